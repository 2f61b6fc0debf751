#include "dataflow/run/events/retimed_config.hpp"

#include <fmt/format.h>

#include "dataflow/base/input_error.hpp"
#include "dataflow/base/program_name.hpp"
#include "dataflow/run/config/config_sources.hpp"
#include "dataflow/run/config/design.hpp"
#include "dataflow/run/config/key_faults.hpp"
#include "dataflow/run/config/keys.hpp"

namespace dataflow::events {

namespace {

std::string why_not(std::string const& key) {
    if (key.rfind("simulation.", 0) == 0)
        return "decides how a run is simulated, and nothing is";
    return design().why_not_retimable(key);
}

std::string why_not(Key const& key, LoadedConfig const& recorded, LoadedConfig const& changed) {
    bool const waits = decides_waits(key, recorded.config) || decides_waits(key, changed.config);
    return waits ? "decides which iterations wait for writes, which was recorded" : why_not(key.name());
}

void require_retimable(LoadedConfig const& recorded, LoadedConfig const& changed) {
    for (Key const& key : all_keys()) {
        if ((is_retimable(key, recorded.config) && !decides_waits(key, changed.config)) ||
            json_text(key.read(recorded.config)) == json_text(key.read(changed.config)))
            continue;
        throw InputError(fmt::format("{}: {} {}, expected a key that decides about time only; use {} run for it",
                                     changed.origins.of(key.name()).place, key.name(), why_not(key, recorded, changed),
                                     program_name()));
    }
}

}  // namespace

LoadedConfig retimed_config(LoadedConfig const& recorded, std::vector<std::string> const& overrides) {
    LoadedConfig changed = recorded;
    std::vector<std::string> complaints;
    for (std::string const& setting : overrides) {
        std::vector<std::string> const more = apply_override(setting, changed);
        complaints.insert(complaints.end(), more.begin(), more.end());
    }
    throw_first(complaints);
    require_retimable(recorded, changed);
    throw_first(cross_check(changed));
    return changed;
}

}  // namespace dataflow::events
