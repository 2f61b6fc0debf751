#pragma once
#include <memory>

#include "config/parts.hpp"
#include "timing/core_timing.hpp"
#include "timing/lookup/group.hpp"

namespace faster::retiming {

/// A core that has done nothing yet, to write operations on and to check them with, and its lead group.
struct LeadCore {
    LeadCore(timing::CoreTiming const& blueprint, timing::Lead const& lead);
    /// The lead is the rasterizer's.
    LeadCore(timing::CoreTiming const& blueprint, Parts const& parts);

    std::unique_ptr<timing::CoreTiming> core;
    timing::Group group;
};

}  // namespace faster::retiming
