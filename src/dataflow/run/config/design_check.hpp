#pragma once
#include "dataflow/core/machine/module_description.hpp"

namespace dataflow {

/// Whether all of them do: the part that has them is there.
bool hold(Conditions const& conditions);

/// What cannot be timed, or would be timed wrongly, whatever the configuration: names that are used twice, parts that
/// are named and not there, an end of a FIFO that several modules have, defaults that no key could say. Errors:
/// InputError.
void check_design(CoreDescription const& core);

}  // namespace dataflow
