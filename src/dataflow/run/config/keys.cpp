#include "dataflow/run/config/keys.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>
#include <set>
#include <utility>

#include "dataflow/base/input_error.hpp"
#include "dataflow/base/nearest_name.hpp"
#include "dataflow/run/config/design.hpp"
#include "dataflow/run/config/key_builders.hpp"
#include "dataflow/run/config/key_names.hpp"

namespace dataflow {
namespace {

Keys simulation_keys() {
    Key engine = KeyMaker<RunConfig>::choice_key(
        {"simulation.engine", "",
         "How the SystemC kernel follows the processes: at every operation (lockstep, for waveforms) or "
         "only when they must wait (decoupled); the results are the same.",
         "timing model"},
        [](auto& config) -> auto& { return config.simulation.engine; });
    engine.decides_figures = false;
    return {engine};
}

Keys make_all_keys() {
    Keys all = design().keys();
    for (Key& key : simulation_keys()) {
        all.push_back(std::move(key));
    }
    require_named_once(all);
    return all;
}

bool starts_with(std::string_view text, std::string_view start) { return text.substr(0, start.size()) == start; }

bool ends_with(std::string_view text, std::string_view end) {
    return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}

std::string below(std::string_view section) { return section.empty() ? std::string{} : std::string(section) + '.'; }

/// The sections and the part of a dotted name that exist, and the first part that does not.
struct KnownPart {
    std::string section;
    std::string unknown;
};

KnownPart split_at_unknown(std::string_view name) {
    KnownPart part;
    std::string_view rest = name;
    while (true) {
        std::string const next(rest.substr(0, rest.find('.')));
        std::string const longer = below(part.section) + next;
        if (!is_section(longer) || next.size() == rest.size()) {
            return {part.section, next};
        }
        part.section = longer;
        rest.remove_prefix(next.size() + 1);
    }
}

/// The only key that ends in `.name`: somebody left out the sections.
std::string only_key_ending_in(std::string_view name) {
    std::string found;
    for (Key const& key : all_keys()) {
        if (ends_with(key.name(), '.' + std::string(name))) {
            if (!found.empty()) {
                return {};
            }
            found = key.name();
        }
    }
    return found;
}

std::string probable_key(std::string_view name, KnownPart const& part) {
    std::string const sibling = nearest_name(part.unknown, names_in_section(part.section));
    if (!sibling.empty() && sibling != part.unknown) {
        std::string const replaced = below(part.section) + sibling;
        std::string const whole = replaced + std::string(name.substr(below(part.section).size() + part.unknown.size()));
        return find_key(whole) != nullptr ? whole : replaced;
    }
    return only_key_ending_in(name);
}

bool is_of_memory(Key const& key) { return starts_with(key.name(), "accelerator.memory."); }

template <class Chosen> Keys keys_that(Chosen const& chosen) {
    Keys keys;
    std::copy_if(all_keys().begin(), all_keys().end(), std::back_inserter(keys), chosen);
    return keys;
}

/// Those of `chosen` that mean something.
template <class Chosen> Keys active_keys(RunConfig const& config, Chosen const& chosen) {
    IdleKeys const idle = idle_keys(config);
    bool const has_memory = config.machine().external_memory.model != MemoryModel::ideal;
    return keys_that([&](Key const& key) {
        return chosen(key) && idle.decider_of(key.name()) == nullptr && (has_memory || !is_of_memory(key));
    });
}

}  // namespace

void require_named_once(Keys const& keys) {
    std::set<std::string> names;
    for (Key const& key : keys)
        if (!names.insert(key.name()).second)
            throw InputError("in the design two keys have the name " + key.name() +
                             ", expected another name for the number of its own");
}

Keys const& all_keys() {
    static Keys const all = make_all_keys();
    return all;
}

Keys timing_keys(RunConfig const& config) {
    return active_keys(config, [](Key const& key) { return key.is_step; });
}

Keys retimable_keys(RunConfig const& config) {
    return active_keys(config, [&](Key const& key) { return is_retimable(key, config); });
}

Keys retiming_keys() {
    return keys_that([](Key const& key) { return key.decides_time; });
}

bool is_retimable(Key const& key, RunConfig const& config) {
    // What comes from a memory that is ideal was not recorded.
    if (key.name() == "accelerator.memory.model" && config.machine().external_memory.model == MemoryModel::ideal)
        return false;
    return key.decides_time && !decides_waits(key, config) && !design().decides_function(key.name(), config);
}

bool decides_waits(Key const& key, RunConfig const& config) {
    auto const& dependences = config.machine().dependences;
    return std::any_of(dependences.begin(), dependences.end(), [&key](auto const& named) {
        return named.second.hazards == HazardHandling::interlock &&
               key.name().rfind(loop_key_name(named.first, ""), 0) == 0;
    });
}

Keys figure_keys() {
    return keys_that([](Key const& key) { return key.of_runs && key.decides_figures; });
}

Key const* find_key(std::string_view name) {
    auto const found =
        std::find_if(all_keys().begin(), all_keys().end(), [&](Key const& key) { return key.name() == name; });
    return found == all_keys().end() ? nullptr : &*found;
}

bool decides_figures(std::string_view name) {
    Key const* const key = find_key(name);
    return key == nullptr || (key->of_runs && key->decides_figures);
}

bool is_section(std::string_view name) {
    return std::any_of(all_keys().begin(), all_keys().end(),
                       [&](Key const& key) { return starts_with(key.name(), below(name)); });
}

std::vector<std::string> names_in_section(std::string_view section) {
    std::string const start = below(section);
    std::vector<std::string> names;
    for (Key const& key : all_keys()) {
        if (starts_with(key.name(), start)) {
            std::string const rest = key.name().substr(start.size());
            std::string const name = rest.substr(0, rest.find('.'));
            if (names.empty() || names.back() != name) {
                names.push_back(name);
            }
        }
    }
    return names;
}

std::string unknown_key_problem(std::string_view name) {
    KnownPart const part = split_at_unknown(name);
    std::string const probable = probable_key(name, part);
    if (!probable.empty()) {
        return fmt::format("unknown key, did you mean {}?", probable);
    }
    if (Key const* const leaf = find_key(below(part.section) + part.unknown); leaf != nullptr) {
        return fmt::format("unknown key, {} has one value and nothing below it", leaf->name());
    }
    std::string const where = part.section.empty() ? "at the top" : "in " + part.section;
    return fmt::format("unknown key, expected {} one of {}", where, fmt::join(names_in_section(part.section), ", "));
}

std::string const& example_key() {
    auto const found =
        std::find_if(all_keys().begin(), all_keys().end(), [](Key const& key) { return key.kind == KeyKind::integer; });
    return (found == all_keys().end() ? all_keys().front() : *found).name();
}

}  // namespace dataflow
