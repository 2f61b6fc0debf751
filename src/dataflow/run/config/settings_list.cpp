#include "dataflow/run/config/settings_list.hpp"

#include <fmt/format.h>

#include "dataflow/base/files/yaml_document.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/run/config/value_reader.hpp"

namespace dataflow {
namespace {

[[noreturn]] void fail(std::filesystem::path const& path, int line, std::string const& what) {
    throw InputError(fmt::format("{}:{}: {}", path.string(), line, what));
}

Settings read_item(std::filesystem::path const& path, YAML::Node const& item, std::string const& example) {
    Settings settings;
    settings.line = item.Mark().line + 1;
    if (!item.IsMap())
        fail(path, settings.line, fmt::format("{}, expected a map such as {{{}}}", shown(item), example));
    KeyFaults faults;
    for (MapEntry const& entry : read_entries(item, "", faults)) {
        if (!entry.value.IsScalar())
            fail(path, entry.line, fmt::format("{}: {}, expected one value", entry.name, shown(entry.value)));
        settings.overrides.push_back(entry.name + "=" + entry.value.Scalar());
    }
    if (!faults.empty())
        fail(path, faults.front().line, faults.front().text());
    return settings;
}

}  // namespace

std::vector<Settings> read_settings_list(std::filesystem::path const& path, std::string const& example) {
    YAML::Node const root = load_document(path, "a list of settings");
    if (!root.IsSequence())
        fail(path, 1, fmt::format("expected a list of maps, one per configuration, such as - {{{}}}", example));
    std::vector<Settings> list;
    for (YAML::Node const& item : root)
        list.push_back(read_item(path, item, example));
    return list;
}

}  // namespace dataflow
