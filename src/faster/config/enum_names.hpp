#pragma once
#include "dataflow/run/config/enum_names.hpp"
#include "faster/config/accelerator_config.hpp"
#include "faster/config/estimator_config.hpp"

namespace dataflow {

/// How the choices of FASTER's keys are written.

template <> struct EnumNames<faster::EdgeMapAlgorithm> {
    static constexpr auto all = [] {
        std::array<std::pair<faster::EdgeMapAlgorithm, char const*>, faster::edge_map_designs.size()> names{};
        for (std::size_t i = 0; i < names.size(); ++i) {
            names[i].first = faster::edge_map_designs[i].algorithm;
            names[i].second = faster::edge_map_designs[i].name;
        }
        return names;
    }();
};

template <> struct EnumNames<faster::Flow> {
    static constexpr std::array<std::pair<faster::Flow, char const*>, 2> all{
        {{faster::Flow::faster, "faster"}, {faster::Flow::fpga_grip, "fpga_grip"}}};
};

template <> struct EnumNames<faster::MapClearing> {
    static constexpr std::array<std::pair<faster::MapClearing, char const*>, 3> all{
        {{faster::MapClearing::loop, "loop"},
         {faster::MapClearing::on_read_out, "on_read_out"},
         {faster::MapClearing::wide, "wide"}}};
};

template <> struct EnumNames<faster::NeighbourAccess> {
    static constexpr std::array<std::pair<faster::NeighbourAccess, char const*>, 2> all{
        {{faster::NeighbourAccess::direct, "direct"}, {faster::NeighbourAccess::window, "window"}}};
};

template <> struct EnumNames<faster::FragmentLoop> {
    static constexpr std::array<std::pair<faster::FragmentLoop, char const*>, 2> all{
        {{faster::FragmentLoop::per_triangle, "per_triangle"}, {faster::FragmentLoop::flattened, "flattened"}}};
};

template <> struct EnumNames<faster::SweepRegion> {
    static constexpr std::array<std::pair<faster::SweepRegion, char const*>, 2> all{
        {{faster::SweepRegion::window, "window"}, {faster::SweepRegion::touched, "touched"}}};
};

template <> struct EnumNames<faster::HiddenPixels> {
    static constexpr std::array<std::pair<faster::HiddenPixels, char const*>, 2> all{
        {{faster::HiddenPixels::ignored, "ignored"}, {faster::HiddenPixels::counted, "counted"}}};
};

template <> struct EnumNames<faster::Placement> {
    static constexpr std::array<std::pair<faster::Placement, char const*>, 2> all{
        {{faster::Placement::external, "external"}, {faster::Placement::on_chip, "on_chip"}}};
};

template <> struct EnumNames<faster::EdgeTokens> {
    static constexpr std::array<std::pair<faster::EdgeTokens, char const*>, 2> all{
        {{faster::EdgeTokens::all, "all"}, {faster::EdgeTokens::object, "object"}}};
};

template <> struct EnumNames<faster::ScanPolicy> {
    static constexpr std::array<std::pair<faster::ScanPolicy, char const*>, 3> all{
        {{faster::ScanPolicy::zigzag, "zigzag"},
         {faster::ScanPolicy::early_exit, "early_exit"},
         {faster::ScanPolicy::spans, "spans"}}};
};

template <> struct EnumNames<faster::EstimatorBackend> {
    static constexpr std::array<std::pair<faster::EstimatorBackend, char const*>, 2> all{
        {{faster::EstimatorBackend::accelerator, "accelerator"}, {faster::EstimatorBackend::grip, "grip"}}};
};

template <> struct EnumNames<faster::Refinement> {
    static constexpr std::array<std::pair<faster::Refinement, char const*>, 2> all{
        {{faster::Refinement::none, "none"}, {faster::Refinement::icp, "icp"}}};
};

template <> struct EnumNames<faster::InBoxTerm> {
    static constexpr std::array<std::pair<faster::InBoxTerm, char const*>, 4> all{
        {{faster::InBoxTerm::overlap, "overlap"},
         {faster::InBoxTerm::all_points, "all_points"},
         {faster::InBoxTerm::box_points, "box_points"},
         {faster::InBoxTerm::none, "none"}}};
};

template <> struct EnumNames<faster::Resampling> {
    static constexpr std::array<std::pair<faster::Resampling, char const*>, 3> all{
        {{faster::Resampling::systematic, "systematic"},
         {faster::Resampling::stratified, "stratified"},
         {faster::Resampling::multinomial, "multinomial"}}};
};

template <> struct EnumNames<faster::EstimateKind> {
    static constexpr std::array<std::pair<faster::EstimateKind, char const*>, 2> all{
        {{faster::EstimateKind::best, "best"}, {faster::EstimateKind::mean, "mean"}}};
};

}  // namespace dataflow
