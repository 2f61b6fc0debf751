#include "dataflow/run/config/resolved_config.hpp"

#include <fmt/format.h>

#include "dataflow/base/fnv1a.hpp"
#include "dataflow/base/text_lines.hpp"
#include "dataflow/run/config/idle_keys.hpp"
#include "dataflow/run/config/key_names.hpp"
#include "dataflow/run/config/keys.hpp"

namespace dataflow {
namespace {

std::string indentation(std::size_t level) { return std::string(2 * level, ' '); }

/// Headings of the sections of `parts` that the key before it, `previous`, was not in.
std::string headings(std::vector<std::string> const& parts, std::vector<std::string> const& previous) {
    std::size_t level = 0;
    while (level + 1 < previous.size() && level + 1 < parts.size() && parts[level] == previous[level]) {
        ++level;
    }
    std::string text;
    for (; level + 1 < parts.size(); ++level) {
        text += indentation(level) + parts[level] + ":\n";
    }
    return text;
}

}  // namespace

std::vector<ResolvedKey> resolved_keys(RunConfig const& config, KeyScope scope) {
    RunConfig const defaults;
    std::vector<ResolvedKey> resolved;
    for (Key const& key : all_keys()) {
        if (scope == KeyScope::of_runs && !key.of_runs) {
            continue;
        }
        KeyValue value = key.read(config);
        bool const is_default = json_text(value) == json_text(key.read(defaults));
        resolved.push_back({key.name(), std::move(value), is_default});
    }
    return resolved;
}

std::string exported_yaml(RunConfig const& config) {
    IdleKeys const idle = idle_keys(config);
    std::vector<ResolvedKey> keys;
    for (ResolvedKey& key : resolved_keys(config))
        if (!key.is_default && key.key != architecture_key_name && idle.decider_of(key.key) == nullptr)
            keys.push_back(std::move(key));
    return to_yaml(keys);
}

std::string to_yaml(RunConfig const& config) { return to_yaml(resolved_keys(config)); }

std::string to_yaml(std::vector<ResolvedKey> const& keys) {
    RunConfig const defaults;
    std::string text;
    std::vector<std::string> previous;
    for (ResolvedKey const& entry : keys) {
        std::vector<std::string> const parts = split_at_points(entry.key);
        text += headings(parts, previous);
        text += fmt::format("{}{}: {}", indentation(parts.size() - 1), parts.back(), json_text(entry.value));
        text +=
            entry.is_default ? "\n" : fmt::format("  # default {}\n", json_text(find_key(entry.key)->read(defaults)));
        previous = parts;
    }
    return text;
}

std::string configuration_hash(std::vector<ResolvedKey> const& keys) {
    std::string lines;
    for (ResolvedKey const& key : keys)
        if (decides_figures(key.key))
            lines += key.key + "=" + json_text(key.value) + "\n";
    return hash_of(lines);
}

std::string hash_of(std::string_view text) { return "fnv1a64:" + fnv1a_digits(text); }

}  // namespace dataflow
