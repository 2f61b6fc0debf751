#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "dataflow/run/config/key_faults.hpp"
#include "dataflow/run/config/value_reader.hpp"

namespace dataflow {

/// For readers of files with maps in them (budgets, sweeps, experiments). What they say of entries is added to
/// `faults`.

/// The entry's value is not as `expected`.
void reject(KeyFaults& faults, MapEntry const& entry, std::string const& expected);

/// What takes the value of an entry of that name.
struct EntryReader {
    std::string name;
    std::function<void(MapEntry const&)> read;
};
/// Hands each entry to the reader of its name. Entries of other names are faults.
void read_each(std::vector<MapEntry> const& entries, std::vector<EntryReader> const& readers, KeyFaults& faults);
/// Reads a file that is `what` ("a sweep") and has the value `format` ("faster-sweep") at its key of that name. At its
/// top are format, version and the names of `readers`, of which those that are `needed` must be there. They are not
/// looked for behind other faults: what is missing may be what is misspelt. Throws InputError for what is no map.
void read_top(std::filesystem::path const& file, std::string const& what, std::string const& format,
              std::vector<EntryReader> readers, std::vector<std::string> needed, KeyFaults& faults);

/// "FILE:LINE: KEY = VALUE, expected ...", of each.
std::vector<std::string> messages_of(KeyFaults const& faults, std::string const& file);
/// Throws InputError for the first of them by line, if there are any.
void throw_first_of(KeyFaults faults, std::string const& file);

}  // namespace dataflow
