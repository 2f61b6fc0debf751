#include "dataflow/run/config/entry_faults.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "dataflow/base/nearest_name.hpp"
#include "dataflow/base/printable.hpp"

namespace dataflow {

void reject(KeyFaults& faults, MapEntry const& entry, std::string const& expected) {
    faults.push_back({entry.line, entry.name, shown(entry.value), "expected " + expected});
}

void reject_name(KeyFaults& faults, MapEntry const& entry, std::vector<std::string> const& names) {
    faults.push_back(
        {entry.line, shortened(entry.name), std::nullopt,
         fmt::format("unknown key, expected one of {}{}", fmt::join(names, ", "), did_you_mean(entry.name, names))});
}

void require_word(KeyFaults& faults, MapEntry const& entry, std::string const& word) {
    if (!entry.value.IsScalar() || entry.value.Scalar() != word)
        reject(faults, entry, word);
}

void require_given(KeyFaults& faults, std::vector<std::string> const& given, std::vector<std::string> const& needed) {
    bool const is_sound = faults.empty();
    for (std::string const& name : needed)
        if (is_sound && std::find(given.begin(), given.end(), name) == given.end())
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
