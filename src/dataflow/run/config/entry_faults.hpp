#pragma once
#include <string>
#include <vector>

#include "dataflow/run/config/key_faults.hpp"
#include "dataflow/run/config/value_reader.hpp"

namespace dataflow {

/// What readers of files with maps in them (budgets, sweeps, experiments) say of an entry, added to `faults`.

/// Its value is not as `expected`.
void reject(KeyFaults& faults, MapEntry const& entry, std::string const& expected);
/// Nothing is called so; `names` are what there is.
void reject_name(KeyFaults& faults, MapEntry const& entry, std::vector<std::string> const& names);
void require_word(KeyFaults& faults, MapEntry const& entry, std::string const& word);
/// What stands at the top of a file must have the names that are `needed`. Not looked for behind other faults: what is
/// missing may be what is misspelt.
void require_given(KeyFaults& faults, std::vector<std::string> const& given, std::vector<std::string> const& needed);

/// "FILE:LINE: KEY = VALUE, expected ...", of each.
std::vector<std::string> messages_of(KeyFaults const& faults, std::string const& file);
/// Throws InputError for the first of them by line, if there are any.
void throw_first_of(KeyFaults faults, std::string const& file);

}  // namespace dataflow
