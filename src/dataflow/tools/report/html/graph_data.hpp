#pragma once
#include "dataflow/base/json.hpp"
#include "dataflow/core/machine/machine.hpp"

namespace dataflow::report {

/// The dataflow graph of a core: its processes, FIFOs, memories, and where to draw them. Graphviz's `dot` places them,
/// twice: from left to right (`wide`), and from top to bottom (`tall`). Without `dot` both are null. Modules have the
/// lines of the source that describe them. Errors: InputError if $FASTER_SOURCE_LINK is no address of such a line.
Json graph_data(Machine const& machine);

/// The memories of a core and their ports.
Json memory_data(Machine const& machine);

}  // namespace dataflow::report
