#pragma once

namespace dataflow::io {}

/// FASTER is written in the words of the kernel: Cycles, Machine, ModuleDescription, io::OutputFile are dataflow's.
namespace faster {
using namespace dataflow;  // NOLINT(google-build-using-namespace)
namespace files {
using namespace dataflow::io;  // NOLINT(google-build-using-namespace)
}
}  // namespace faster
