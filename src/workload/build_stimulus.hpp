#pragma once
#include "common/stimulus.hpp"
#include "faster/workload_config.hpp"

namespace faster::workload {

/// Makes the work of a run from its description: the object's mesh, the observed scene (rendered, or a depth image),
/// its edges, and the pose samples. The result is posed: the vertex transform is still to be done. `config.trace` is
/// not looked at. Throws InputError naming the key or file.
Stimulus build_stimulus(WorkloadConfig const& config, int window, FractionBits const& fraction);

}  // namespace faster::workload
