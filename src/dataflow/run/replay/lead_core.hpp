#pragma once
#include <memory>

#include "dataflow/core/time/core_timing.hpp"
#include "dataflow/phrases/group.hpp"

namespace dataflow::replay {

/// A core that has done nothing yet, to write operations on and to check them with, and its lead group.
struct LeadCore {
    LeadCore(timing::CoreTiming const& blueprint, timing::Lead const& lead)
        : core(blueprint.blank_copy()), group(*core, lead) {}

    /// Without followers, nothing is worth being told as phrases.
    bool has_followers() const { return group.members().size() > 1; }

    std::unique_ptr<timing::CoreTiming> core;
    timing::Group group;
};

}  // namespace dataflow::replay
