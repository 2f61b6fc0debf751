#include "dataflow/run/config/entry_faults.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "dataflow/base/files/yaml_document.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/base/nearest_name.hpp"
#include "dataflow/base/printable.hpp"

namespace dataflow {

namespace {

std::vector<std::string> names_of(std::vector<EntryReader> const& readers) {
    std::vector<std::string> names;
    names.reserve(readers.size());
    for (EntryReader const& reader : readers)
        names.push_back(reader.name);
    return names;
}

template <class Named> auto find_named(std::string const& name, std::vector<Named> const& list) {
    return std::find_if(list.begin(), list.end(), [&name](Named const& named) { return named.name == name; });
}

}  // namespace

void reject(KeyFaults& faults, MapEntry const& entry, std::string const& expected) {
    faults.push_back({entry.line, entry.name, shown(entry.value), "expected " + expected});
}

void read_each(std::vector<MapEntry> const& entries, std::vector<EntryReader> const& readers, KeyFaults& faults) {
    std::vector<std::string> const names = names_of(readers);
    for (MapEntry const& entry : entries)
        if (auto const reader = find_named(entry.name, readers); reader != readers.end())
            reader->read(entry);
        else
            faults.push_back({entry.line, shortened(entry.name), std::nullopt,
                              fmt::format("unknown key, expected one of {}{}", fmt::join(names, ", "),
                                          did_you_mean(entry.name, names))});
}

void read_top(std::filesystem::path const& file, std::string const& what, std::string const& format,
              std::vector<EntryReader> readers, std::vector<std::string> needed, KeyFaults& faults) {
    auto const require = [&faults](MapEntry const& entry, std::string const& word) {
        if (!entry.value.IsScalar() || entry.value.Scalar() != word)
            reject(faults, entry, word);
    };
    readers.insert(readers.begin(), {{"format", [&](MapEntry const& entry) { require(entry, format); }},
                                     {"version", [&](MapEntry const& entry) { require(entry, "1"); }}});
    needed.insert(needed.begin(), {"format", "version"});
    std::vector<std::string> const names = names_of(readers);
    YAML::Node const root = load_document(file, what + " file", names);
    if (!root.IsMap())
        throw InputError(fmt::format("{}:1: {}, expected {}: a map with {}", file.string(), shown(root), what,
                                     fmt::join(names, ", ")));
    std::vector<MapEntry> const entries = read_entries(root, "", faults);
    read_each(entries, readers, faults);
    bool const is_sound = faults.empty();
    for (std::string const& name : needed)
        if (is_sound && find_named(name, entries) == entries.end())
            faults.push_back({1, name, std::nullopt, "missing, expected it at the top of the file"});
}

std::vector<std::string> messages_of(KeyFaults const& faults, std::string const& file) {
    std::vector<std::string> messages;
    for (KeyFault const& fault : faults)
        messages.push_back(fmt::format("{}:{}: {}", file, fault.line, fault.text()));
    return messages;
}

void throw_first_of(KeyFaults faults, std::string const& file) {
    std::stable_sort(faults.begin(), faults.end(),
                     [](KeyFault const& a, KeyFault const& b) { return a.line < b.line; });
    throw_first(messages_of(faults, file));
}

}  // namespace dataflow
