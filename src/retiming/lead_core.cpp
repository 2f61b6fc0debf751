#include "retiming/lead_core.hpp"

#include "modules/core_shapes.hpp"

namespace faster::retiming {

LeadCore::LeadCore(timing::CoreTiming const& blueprint, Parts const& parts)
    : core(blueprint.blank_copy()), group(*core, rasterizer_and_followers(parts)) {}

}  // namespace faster::retiming
