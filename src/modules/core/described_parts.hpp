#pragma once
#include <algorithm>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "dataflow/core/machine/module_description.hpp"
#include "faster/dataflow_names.hpp"

namespace faster {

/// What a module's description says of an end, loop or memory that it has already, for a variant to change.
/// Errors: std::logic_error if it has none.
template <class Part>
Part& part_of(ModuleDescription const& module, std::vector<Part>& parts, std::string Part::*name,
              std::string_view wanted) {
    auto const found = std::find_if(parts.begin(), parts.end(), [=](Part const& part) { return part.*name == wanted; });
    if (found == parts.end())
        throw std::logic_error("module " + module.name + " describes no " + std::string(wanted));
    return *found;
}
inline FifoEnd& end_of(ModuleDescription& module, std::string_view fifo) {
    return part_of(module, module.ends, &FifoEnd::fifo, fifo);
}
inline LoopDescription& loop_of(ModuleDescription& module, std::string_view loop) {
    return part_of(module, module.loops, &LoopDescription::name, loop);
}
inline MemoryDescription& memory_of(ModuleDescription& module, std::string_view memory) {
    return part_of(module, module.memories, &MemoryDescription::name, memory);
}

}  // namespace faster
