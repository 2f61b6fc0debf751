#pragma once
#include "faster/accelerator_config.hpp"
#include "faster/estimator_config.hpp"
#include "kernel/config/enum_names.hpp"

namespace faster {

/// How the choices of FASTER's keys are written.

template <> struct EnumNames<EdgeMapAlgorithm> {
    static constexpr std::array<std::pair<EdgeMapAlgorithm, char const*>, 6> all{
        {{EdgeMapAlgorithm::threshold, "threshold"},
         {EdgeMapAlgorithm::transition, "transition"},
         {EdgeMapAlgorithm::bounded, "bounded"},
         {EdgeMapAlgorithm::dual_map, "dual_map"},
         {EdgeMapAlgorithm::dual_map_4_1_2, "dual_map_4_1_2"},
         {EdgeMapAlgorithm::inner_border, "inner_border"}}};
};

template <> struct EnumNames<Flow> {
    static constexpr std::array<std::pair<Flow, char const*>, 2> all{
        {{Flow::faster, "faster"}, {Flow::fpga_grip, "fpga_grip"}}};
};

template <> struct EnumNames<MapClearing> {
    static constexpr std::array<std::pair<MapClearing, char const*>, 3> all{
        {{MapClearing::loop, "loop"}, {MapClearing::on_read_out, "on_read_out"}, {MapClearing::wide, "wide"}}};
};

template <> struct EnumNames<NeighbourAccess> {
    static constexpr std::array<std::pair<NeighbourAccess, char const*>, 2> all{
        {{NeighbourAccess::direct, "direct"}, {NeighbourAccess::window, "window"}}};
};

template <> struct EnumNames<FragmentLoop> {
    static constexpr std::array<std::pair<FragmentLoop, char const*>, 2> all{
        {{FragmentLoop::per_triangle, "per_triangle"}, {FragmentLoop::flattened, "flattened"}}};
};

template <> struct EnumNames<SweepRegion> {
    static constexpr std::array<std::pair<SweepRegion, char const*>, 2> all{
        {{SweepRegion::window, "window"}, {SweepRegion::touched, "touched"}}};
};

template <> struct EnumNames<Placement> {
    static constexpr std::array<std::pair<Placement, char const*>, 2> all{
        {{Placement::external, "external"}, {Placement::on_chip, "on_chip"}}};
};

template <> struct EnumNames<EdgeTokens> {
    static constexpr std::array<std::pair<EdgeTokens, char const*>, 2> all{
        {{EdgeTokens::all, "all"}, {EdgeTokens::object, "object"}}};
};

template <> struct EnumNames<ScanPolicy> {
    static constexpr std::array<std::pair<ScanPolicy, char const*>, 3> all{
        {{ScanPolicy::zigzag, "zigzag"}, {ScanPolicy::early_exit, "early_exit"}, {ScanPolicy::spans, "spans"}}};
};

template <> struct EnumNames<EstimatorBackend> {
    static constexpr std::array<std::pair<EstimatorBackend, char const*>, 2> all{
        {{EstimatorBackend::accelerator, "accelerator"}, {EstimatorBackend::grip, "grip"}}};
};

template <> struct EnumNames<Resampling> {
    static constexpr std::array<std::pair<Resampling, char const*>, 3> all{{{Resampling::systematic, "systematic"},
                                                                            {Resampling::stratified, "stratified"},
                                                                            {Resampling::multinomial, "multinomial"}}};
};

template <> struct EnumNames<EstimateKind> {
    static constexpr std::array<std::pair<EstimateKind, char const*>, 2> all{
        {{EstimateKind::best, "best"}, {EstimateKind::mean, "mean"}}};
};

}  // namespace faster
