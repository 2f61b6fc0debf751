#include "dataflow/run/config/design.hpp"

#include <algorithm>

#include "dataflow/run/config/design_check.hpp"

namespace dataflow {

RunConfig::RunConfig() : design_(design().default_config()) {}

void Design::require_keys_of_parts(RunConfig const& /*config*/) const {}
std::vector<std::string> Design::complaints(LoadedConfig const& /*loaded*/) const { return {}; }

std::string Design::workload_table() const { return {}; }
IdleKeys Design::idle_keys(RunConfig const& /*config*/) const { return {}; }

bool Design::decides_function(std::string const& /*key*/, RunConfig const& /*config*/) const { return false; }

std::string Design::why_not_retimable(std::string const& key) const {
    bool const is_number_of_module = key.rfind("accelerator.modules.", 0) == 0;
    return is_number_of_module ? "decides which operations there are, not when" : "decides what is computed, not when";
}

std::vector<Preset> const& Design::presets() const {
    static std::vector<Preset> const none;
    return none;
}

std::size_t Design::counters_of_all() const { return counters().size(); }
std::size_t Design::counters_of(RunConfig const& /*config*/) const { return counters().size(); }

bool Design::leaves_out_of_loops_csv(std::string const& /*loop*/) const { return false; }

std::string Design::main_counter() const { return counters().empty() ? "" : counters().front().name; }

std::vector<std::filesystem::path> Design::files_of(std::filesystem::path const& folder) const {
    std::vector<std::filesystem::path> files;
    for (auto const& entry : std::filesystem::recursive_directory_iterator(folder))
        if (entry.is_regular_file())
            files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

std::vector<std::string> preset_names() {
    std::vector<std::string> names;
    for (Preset const& preset : design().presets())
        names.push_back(preset.name);
    std::string const first = design().name();
    std::stable_partition(names.begin(), names.end(), [&first](std::string const& name) { return name == first; });
    return names;
}

std::string const& cores_are() {
    static std::string const name = design().core(RunConfig()).cores_are;
    return name;
}

Machine machine_of(RunConfig const& config) {
    CoreDescription const core = design().core(config);
    check_design(core);
    return make_machine(core, config.machine());
}

}  // namespace dataflow
