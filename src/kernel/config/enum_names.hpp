#pragma once
#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "faster/accelerator_config.hpp"
#include "faster/run_config.hpp"

namespace faster {

/// How the enumerators of a choice are written in configuration files and reports.
template <class Enum> struct EnumNames;

template <> struct EnumNames<FifoKind> {
    static constexpr std::array<std::pair<FifoKind, char const*>, 3> all{
        {{FifoKind::automatic, "auto"}, {FifoKind::shift_register, "shift_register"}, {FifoKind::memory, "memory"}}};
};

template <> struct EnumNames<PartitionType> {
    static constexpr std::array<std::pair<PartitionType, char const*>, 3> all{
        {{PartitionType::none, "none"}, {PartitionType::cyclic, "cyclic"}, {PartitionType::block, "block"}}};
};

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

template <> struct EnumNames<EdgeTokens> {
    static constexpr std::array<std::pair<EdgeTokens, char const*>, 2> all{
        {{EdgeTokens::all, "all"}, {EdgeTokens::object, "object"}}};
};

template <> struct EnumNames<ScanPolicy> {
    static constexpr std::array<std::pair<ScanPolicy, char const*>, 3> all{
        {{ScanPolicy::zigzag, "zigzag"}, {ScanPolicy::early_exit, "early_exit"}, {ScanPolicy::spans, "spans"}}};
};

template <> struct EnumNames<Engine> {
    static constexpr std::array<std::pair<Engine, char const*>, 2> all{
        {{Engine::lockstep, "lockstep"}, {Engine::decoupled, "decoupled"}}};
};

/// The written names, in the order of the table above.
template <class Enum> std::vector<std::string> names_of_choices() {
    std::vector<std::string> names;
    names.reserve(EnumNames<Enum>::all.size());
    for (auto const& entry : EnumNames<Enum>::all) {
        names.emplace_back(entry.second);
    }
    return names;
}

template <class Enum> std::string choice_name(Enum value) {
    for (auto const& [candidate, name] : EnumNames<Enum>::all) {
        if (candidate == value) {
            return name;
        }
    }
    return {};
}

/// `name` must be one of names_of_choices(): the readers check before.
template <class Enum> Enum choice_from_name(std::string_view name) {
    for (auto const& [candidate, candidate_name] : EnumNames<Enum>::all) {
        if (name == candidate_name) {
            return candidate;
        }
    }
    return Enum{};
}

}  // namespace faster
