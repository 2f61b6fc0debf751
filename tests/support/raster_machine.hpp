#pragma once
#include "dataflow/core/machine/machine.hpp"
#include "faster/dataflow_names.hpp"
#include "modules/core/raster_core_description.hpp"
#include "support/parts.hpp"

namespace faster::testing {

/// The machine of a configuration, as the modules describe it.
inline Machine raster_machine(AcceleratorConfig const& config) {
    return make_machine(describe_raster_core(config), config);
}

inline timing::InitiationInterval initiation_interval(LoopId id, AcceleratorConfig const& config) {
    return raster_machine(config).loops.at(index_of(id)).interval;
}

inline MemoryShape memory_shape(BramId id, AcceleratorConfig const& config) {
    return raster_machine(config).memories.at(index_of(id)).shape;
}

/// The inlier unit's; no words if it has none.
inline MemoryShape line_buffer_shape(AcceleratorConfig const& config) {
    Machine const machine = raster_machine(config);
    if (machine.line_buffers.empty())
        return {};
    return {machine.line_buffers.at(0).words, machine.line_buffers.at(0).bits};
}

}  // namespace faster::testing
