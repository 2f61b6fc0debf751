#pragma once
#include <cstddef>
#include <vector>

#include "dataflow/core/machine/machine.hpp"

namespace dataflow::sizing {

/// FIFOs behind a flushing pipeline that freezes while they are full. With one of them, more room or less latency
/// somewhere may make a run longer: a token that reaches the full FIFO sooner freezes the pipeline for longer, and
/// with it those behind it.
std::vector<std::size_t> freezing_fifos(Machine const& machine);

/// Whether cores, or masters of one, wait for each other at an external memory. Then more room or less latency may make
/// a run longer: who asks for a burst sooner may be served before another who is waited for.
bool shares_memory(Machine const& machine);

/// A machine like this one, with pipelines whose tokens close up (WhenFull::squeeze), and with a memory that every
/// master has to itself. It is a relaxation: what the machine does is possible there too, and the relaxed machine does
/// everything as soon as possible, so it takes no longer with the same FIFOs. Without external memory it takes just as
/// long where no such FIFO is ever full. And more room or less latency never makes it take longer.
Machine relaxed(Machine machine);

}  // namespace dataflow::sizing
