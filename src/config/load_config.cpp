#include "config/load_config.hpp"

#include "config/config_sources.hpp"
#include "config/key_faults.hpp"

namespace faster {

LoadedConfig load_config(std::filesystem::path const& path, std::vector<std::string> const& overrides) {
    LoadedConfig loaded;
    std::vector<std::string> complaints = apply_file(path, loaded);
    for (std::string const& setting : overrides) {
        std::vector<std::string> more = apply_override(setting, loaded);
        complaints.insert(complaints.end(), more.begin(), more.end());
    }
    throw_first(complaints);
    throw_first(cross_check(loaded));
    return loaded;
}

}  // namespace faster
