#include "kernel/events/retimed_config.hpp"

#include <fmt/format.h>

#include "faster/retimable.hpp"
#include "kernel/base/input_error.hpp"
#include "kernel/config/config_sources.hpp"
#include "kernel/config/key_faults.hpp"
#include "kernel/config/keys.hpp"

namespace faster::events {

namespace {

bool starts_with(std::string const& text, std::string_view start) { return text.compare(0, start.size(), start) == 0; }

std::string why_not(std::string const& key) {
    if (starts_with(key, "workload."))
        return "is part of the workload, which was recorded";
    if (starts_with(key, "simulation."))
        return "decides how a run is simulated, and nothing is";
    if (starts_with(key, "accelerator.rasterizer.") || key == "accelerator.inlier_unit.fragment_loop")
        return "decides which operations there are, not when";
    if (starts_with(key, "accelerator.brams."))
        return "decides how many iterations a wide clearing loop has";
    if (starts_with(key, "accelerator.inlier_unit.") || key == "accelerator.edge_map.clearing")
        return "decides which operations there are, not only when";
    return "decides what is computed, not when";
}

void require_retimable(LoadedConfig const& recorded, LoadedConfig const& changed) {
    for (Key const& key : all_keys()) {
        if (is_retimable(key, recorded.config.accelerator) ||
            json_text(key.read(recorded.config)) == json_text(key.read(changed.config)))
            continue;
        throw InputError(
            fmt::format("{}: {} {}, expected a key that decides about time only; use faster-sim run for it",
                        changed.origins.of(key.name()).place, key.name(), why_not(key.name())));
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

}  // namespace faster::events
