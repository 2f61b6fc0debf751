#pragma once
#include "kernel/machine/machine.hpp"

namespace faster {

/// Who sets the pace of a machine that has everything but its lead.
timing::Lead lead_of(CoreDescription::Pace const& pace, Machine const& machine);

}  // namespace faster
