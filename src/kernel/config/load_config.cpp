#include "kernel/config/load_config.hpp"

#include "kernel/config/config_sources.hpp"
#include "kernel/config/key_faults.hpp"
#include "kernel/config/key_names.hpp"
#include "kernel/config/layered_config.hpp"

namespace faster {

LoadedConfig load_config(std::filesystem::path const& path, std::vector<std::string> const& overrides) {
    return layered_config({path}, overrides);
}

LoadedConfig load_preset(std::string const& name) {
    LoadedConfig loaded;
    throw_first(apply_preset(name, loaded));
    throw_first(apply_override(std::string(architecture_key_name) + '=' + name, loaded));
    throw_first(cross_check(loaded));
    return loaded;
}

}  // namespace faster
