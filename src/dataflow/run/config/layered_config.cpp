#include "dataflow/run/config/layered_config.hpp"

#include "dataflow/run/config/config_sources.hpp"
#include "dataflow/run/config/design.hpp"
#include "dataflow/run/config/key_faults.hpp"
#include "dataflow/run/config/key_names.hpp"
#include "dataflow/run/config/keys.hpp"

namespace dataflow {

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

}  // namespace

LoadedConfig layered_config(Files const& files, std::vector<std::string> const& overrides) {
    LoadedConfig loaded;
    std::vector<std::string> complaints = apply_all(files, overrides, loaded);
    if (loaded.origins.is_explicit(architecture_key_name)) {
        // A preset lies below files and command line, and any may name it: it is known only when all have been read.
        auto const architecture = std::get<std::string>(find_key(architecture_key_name)->read(loaded.config));
        loaded = {};
        throw_first(apply_preset(architecture, loaded));
        complaints = apply_all(files, overrides, loaded);
    }
    throw_first(complaints);
    design().require_keys_of_parts(loaded.config);
    throw_first(cross_check(loaded));
    return loaded;
}

}  // namespace dataflow
