#pragma once
#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "dataflow/base/enum_size.hpp"
#include "dataflow/core/machine/external_memory_settings.hpp"
#include "dataflow/core/machine/fifo_kind.hpp"
#include "dataflow/core/machine/machine_settings.hpp"
#include "dataflow/core/machine/partition_config.hpp"
#include "dataflow/run/config/run_config.hpp"

namespace dataflow {

/// How the enumerators of a choice are written in configuration files and reports.
template <class Enum> struct EnumNames;

template <> struct EnumNames<FifoGeneration> {
    static constexpr std::array<std::pair<FifoGeneration, char const*>, 3> all{
        {{FifoGeneration::spec, "spec"},
         {FifoGeneration::vivado_hls, "vivado_hls"},
         {FifoGeneration::vitis_hls, "vitis_hls"}}};
};

template <> struct EnumNames<HazardHandling> {
    static constexpr std::array<std::pair<HazardHandling, char const*>, 3> all{
        {{HazardHandling::report, "report"},
         {HazardHandling::interlock, "interlock"},
         {HazardHandling::forward, "forward"}}};
};

template <> struct EnumNames<FifoKind> {
    static constexpr std::array<std::pair<FifoKind, char const*>, 3> all{
        {{FifoKind::automatic, "auto"}, {FifoKind::shift_register, "shift_register"}, {FifoKind::memory, "memory"}}};
};

template <> struct EnumNames<WhenFull> {
    static constexpr std::array<std::pair<WhenFull, char const*>, 2> all{
        {{WhenFull::freeze, "freeze"}, {WhenFull::squeeze, "squeeze"}}};
};

template <> struct EnumNames<PartitionType> {
    static constexpr std::array<std::pair<PartitionType, char const*>, 3> all{
        {{PartitionType::none, "none"}, {PartitionType::cyclic, "cyclic"}, {PartitionType::block, "block"}}};
};

template <> struct EnumNames<CallOrder> {
    static constexpr std::array<std::pair<CallOrder, char const*>, 2> all{
        {{CallOrder::overlapped, "overlapped"}, {CallOrder::in_turn, "in_turn"}}};
};

template <> struct EnumNames<MemoryModel> {
    static constexpr std::array<std::pair<MemoryModel, char const*>, 2> all{
        {{MemoryModel::ideal, "ideal"}, {MemoryModel::axi, "axi"}}};
};

template <> struct EnumNames<Engine> {
    static constexpr std::array<std::pair<Engine, char const*>, 2> all{
        {{Engine::lockstep, "lockstep"}, {Engine::decoupled, "decoupled"}}};
};

/// The written names, in the order of the table above.
template <class Enum> std::vector<std::string> names_of_choices() {
    static_assert(has_a_row_for_each<Enum>(EnumNames<Enum>::all, [](auto const& entry) { return entry.first; }),
                  "EnumNames has a row for every enumerator, in their order");
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

}  // namespace dataflow
