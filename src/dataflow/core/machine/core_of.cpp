#include "dataflow/core/machine/core_of.hpp"

#include <algorithm>
#include <utility>

#include "dataflow/base/input_error.hpp"

namespace dataflow {

CoreDescription core_of(std::vector<ModuleDescription> modules) {
    CoreDescription core;
    if (modules.empty())
        throw InputError("the design has no module, expected at least one");
    for (ModuleDescription const& module : modules)
        for (FifoEnd const& end : module.ends)
            if (end.writes && std::find(core.fifos.begin(), core.fifos.end(), end.fifo) == core.fifos.end())
                core.fifos.push_back(end.fifo);
    modules.back().stamps_look_back = true;
    core.begins = modules.front().name;
    core.ends = modules.back().name;
    core.modules = std::move(modules);
    return core;
}

}  // namespace dataflow
