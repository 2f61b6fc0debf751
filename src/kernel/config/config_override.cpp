#include <fmt/format.h>

#include "kernel/base/files/yaml_document.hpp"
#include "kernel/base/printable.hpp"
#include "kernel/base/utf8.hpp"
#include "kernel/config/config_sources.hpp"
#include "kernel/config/keys.hpp"
#include "kernel/config/value_reader.hpp"

namespace faster {
namespace {

/// A list is YAML; everything else is taken as it stands, so that a path needs no quotes against `#` or `: `.
YAML::Node node_of(Key const& key, std::string const& value) {
    bool const is_list = key.kind == KeyKind::vector || key.kind == KeyKind::items;
    return is_list ? parse_document(value) : YAML::Node(value);
}

std::string fault_text(KeyFault const& fault, Key const& key) {
    return fault.key == key.name() && fault.found ? fault.problem : fault.text();
}

std::vector<std::string> apply_value(Key const& key, std::string const& value, std::string const& place,
                                     LoadedConfig& loaded) {
    KeyFaults faults;
    try {
        if (auto const sound = read_value(key, node_of(key, value), 1, {}, faults)) {
            key.write(loaded.config, *sound);
            loaded.origins.record(key.name(), {KeySource::command_line, place});
        }
    } catch (YAML::Exception const& error) {
        return {fmt::format("{}: expected {} ({})", place, expectation(key), shortened(error.msg))};
    }
    std::vector<std::string> messages;
    for (KeyFault const& fault : faults) {
        messages.push_back(place + ": " + fault_text(fault, key));
    }
    return messages;
}

}  // namespace

std::vector<std::string> apply_override(std::string const& setting, LoadedConfig& loaded) {
    std::string const place = "--set " + shortened(setting);
    if (first_bad_byte(setting)) {
        return {place + ": expected printable UTF-8 text"};
    }
    std::size_t const equals = setting.find('=');
    if (equals == std::string::npos || equals == 0) {
        return {place + ": expected KEY=VALUE"};
    }
    std::string const name = setting.substr(0, equals);
    if (Key const* const key = find_key(name); key != nullptr) {
        return apply_value(*key, setting.substr(equals + 1), place, loaded);
    }
    if (is_section(name)) {
        return {fmt::format("{}: {} is a section, expected a key in it, one of {}", place, name,
                            fmt::join(names_in_section(name), ", "))};
    }
    return {place + ": " + unknown_key_problem(name)};
}

}  // namespace faster
