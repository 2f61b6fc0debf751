#pragma once
#include <string>

#include "dataflow/core/machine/module_description.hpp"

namespace dataflow {

/// Whether all of them do: the part that has them is there.
bool hold(Conditions const& conditions);

/// Whether keys and tables can have that name. `null` is none in a configuration file.
bool is_word(std::string const& name);

/// What cannot be timed, or would be timed wrongly, whatever the configuration: names that are used twice, parts that
/// are named and not there, an end of a FIFO that several modules have, defaults that no key could say. Errors:
/// InputError.
void check_design(CoreDescription const& core);

}  // namespace dataflow
