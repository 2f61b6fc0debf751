#include "dataflow/core/machine/core_of.hpp"

#include <algorithm>
#include <utility>

namespace dataflow {

CoreDescription core_of(std::vector<ModuleDescription> modules) {
    CoreDescription core;
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
