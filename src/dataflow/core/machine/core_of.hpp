#pragma once
#include <vector>

#include "dataflow/core/machine/module_description.hpp"

namespace dataflow {

/// The core that these modules make: its FIFOs are those that the modules write, in that order; its first module begins
/// samples, its last one ends them, with the last cycle that it lets pass.
CoreDescription core_of(std::vector<ModuleDescription> modules);

}  // namespace dataflow
