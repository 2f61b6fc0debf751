#include "faster/presets.hpp"

#include <algorithm>

namespace faster {

std::vector<std::string> preset_names() {
    std::vector<std::string> names;
    for (Preset const& preset : presets())
        names.push_back(preset.name);
    std::stable_partition(names.begin(), names.end(), [](std::string const& name) { return name == "faster"; });
    return names;
}

}  // namespace faster
