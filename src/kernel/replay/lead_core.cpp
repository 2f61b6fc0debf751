#include "kernel/replay/lead_core.hpp"

#include "modules/core_shapes.hpp"

namespace faster::retiming {

LeadCore::LeadCore(timing::CoreTiming const& blueprint, timing::Lead const& lead)
    : core(blueprint.blank_copy()), group(*core, lead) {}

LeadCore::LeadCore(timing::CoreTiming const& blueprint, Parts const& parts)
    : LeadCore(blueprint, rasterizer_and_followers(parts)) {}

}  // namespace faster::retiming
