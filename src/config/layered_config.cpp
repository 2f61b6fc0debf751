#include "config/layered_config.hpp"

#include "config/config_sources.hpp"
#include "config/key_faults.hpp"

namespace faster {

LoadedConfig layered_config(std::vector<std::filesystem::path> const& files,
                            std::vector<std::string> const& overrides) {
    LoadedConfig loaded;
    std::vector<std::string> complaints;
    auto const note = [&complaints](std::vector<std::string> const& more) {
        complaints.insert(complaints.end(), more.begin(), more.end());
    };
    for (std::filesystem::path const& file : files)
        note(apply_file(file, loaded));
    for (std::string const& setting : overrides)
        note(apply_override(setting, loaded));
    throw_first(complaints);
    throw_first(cross_check(loaded));
    return loaded;
}

}  // namespace faster
