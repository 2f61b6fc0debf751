#include "config/load_config.hpp"

#include "config/layered_config.hpp"

namespace faster {

LoadedConfig load_config(std::filesystem::path const& path, std::vector<std::string> const& overrides) {
    return layered_config({path}, overrides);
}

}  // namespace faster
