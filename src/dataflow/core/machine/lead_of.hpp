#pragma once
#include "dataflow/core/machine/machine.hpp"

namespace dataflow {

/// Who sets the pace of a machine that has everything but its lead.
timing::Lead lead_of(CoreDescription::Pace const& pace, Machine const& machine);

}  // namespace dataflow
