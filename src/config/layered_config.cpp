#include "config/layered_config.hpp"

#include "config/config_sources.hpp"
#include "config/key_faults.hpp"

namespace faster {

namespace {

using Files = std::vector<std::filesystem::path>;

std::vector<std::string> apply_all(Files const& files, std::vector<std::string> const& overrides,
                                   LoadedConfig& loaded) {
    std::vector<std::string> complaints;
    auto const note = [&complaints](std::vector<std::string> const& more) {
        complaints.insert(complaints.end(), more.begin(), more.end());
    };
    for (std::filesystem::path const& file : files)
        note(apply_file(file, loaded));
    for (std::string const& setting : overrides)
        note(apply_override(setting, loaded));
    return complaints;
}

/// A preset lies below files and command line, and any may name it: it is known only when all have been read.
LoadedConfig with_preset(Files const& files, std::vector<std::string> const& overrides) {
    LoadedConfig named;
    apply_all(files, overrides, named);
    LoadedConfig loaded;
    if (named.origins.is_explicit("accelerator.architecture"))
        throw_first(apply_preset(named.config.accelerator.architecture, loaded));
    return loaded;
}

}  // namespace

LoadedConfig layered_config(Files const& files, std::vector<std::string> const& overrides) {
    LoadedConfig loaded = with_preset(files, overrides);
    throw_first(apply_all(files, overrides, loaded));
    throw_first(cross_check(loaded));
    return loaded;
}

}  // namespace faster
