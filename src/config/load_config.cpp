#include "config/load_config.hpp"

#include "config/config_sources.hpp"
#include "config/key_faults.hpp"

namespace faster {

namespace {

std::vector<std::string> apply_all(std::filesystem::path const& path, std::vector<std::string> const& overrides,
                                   LoadedConfig& loaded) {
    std::vector<std::string> complaints = apply_file(path, loaded);
    for (std::string const& setting : overrides) {
        std::vector<std::string> more = apply_override(setting, loaded);
        complaints.insert(complaints.end(), more.begin(), more.end());
    }
    return complaints;
}

/// A preset lies below file and command line, and either may name it: it is known only when both have been read.
LoadedConfig with_preset(std::filesystem::path const& path, std::vector<std::string> const& overrides) {
    LoadedConfig named;
    apply_all(path, overrides, named);
    LoadedConfig loaded;
    if (named.origins.is_explicit("accelerator.architecture"))
        throw_first(apply_preset(named.config.accelerator.architecture, loaded));
    return loaded;
}

}  // namespace

LoadedConfig load_config(std::filesystem::path const& path, std::vector<std::string> const& overrides) {
    LoadedConfig loaded = with_preset(path, overrides);
    throw_first(apply_all(path, overrides, loaded));
    throw_first(cross_check(loaded));
    return loaded;
}

LoadedConfig load_preset(std::string const& name) {
    LoadedConfig loaded;
    throw_first(apply_preset(name, loaded));
    throw_first(apply_override("accelerator.architecture=" + name, loaded));
    throw_first(cross_check(loaded));
    return loaded;
}

}  // namespace faster
