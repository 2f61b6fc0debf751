#include <fmt/format.h>
#include <stdexcept>

#include "dataflow/run/config/config_sources.hpp"
#include "dataflow/run/config/design.hpp"
#include "dataflow/run/config/keys.hpp"

namespace dataflow {
namespace {

/// A key of a part that is not there would change nothing. Its default is no complaint: a resolved configuration says
/// all.
std::vector<std::string> complaints_about_parts(LoadedConfig const& loaded) {
    IdleKeys const idle = idle_keys(loaded.config);
    RunConfig const defaults;
    std::vector<std::string> complaints;
    for (Key const& key : all_keys()) {
        std::string const* const decider = idle.decider_of(key.name());
        bool const is_asked_for = loaded.origins.is_explicit(key.name()) &&
                                  json_text(key.read(loaded.config)) != json_text(key.read(defaults));
        if (decider != nullptr && is_asked_for) {
            complaints.push_back(complaint(
                loaded, key.name(), fmt::format("a key of the parts that {} has", with_value(loaded, *decider))));
        }
    }
    return complaints;
}

}  // namespace

std::string with_value(LoadedConfig const& loaded, std::string const& key) {
    Key const* const found = find_key(key);
    if (found == nullptr)
        throw std::logic_error("a design names the key " + key + ", which it does not have");
    return fmt::format("{} = {}{}", key, json_text(found->read(loaded.config)),
                       loaded.origins.is_explicit(key) ? "" : " (default)");
}

std::string complaint(LoadedConfig const& loaded, std::string const& key, std::string const& expected) {
    KeyOrigin const origin = loaded.origins.of(key);
    if (origin.source == KeySource::command_line) {
        return origin.place + ": expected " + expected;  // key and value stand in the place
    }
    std::string const value = with_value(loaded, key) + ", expected " + expected;
    return origin.place.empty() ? value : origin.place + ": " + value;
}

std::vector<std::string> cross_check(LoadedConfig const& loaded) {
    std::vector<std::string> complaints = machine_complaints(loaded);
    for (auto const& more : {design().complaints(loaded), complaints_about_parts(loaded)})
        complaints.insert(complaints.end(), more.begin(), more.end());
    return complaints;
}

}  // namespace dataflow
