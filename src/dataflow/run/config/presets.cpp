#include "dataflow/run/config/presets.hpp"

#include <algorithm>

#include "dataflow/run/config/design.hpp"

namespace dataflow {

std::vector<std::string> preset_names() {
    std::vector<std::string> names;
    for (Preset const& preset : design().presets())
        names.push_back(preset.name);
    std::string const first = design().name();
    std::stable_partition(names.begin(), names.end(), [&first](std::string const& name) { return name == first; });
    return names;
}

}  // namespace dataflow
