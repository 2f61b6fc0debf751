#pragma once
#include "kernel/machine/module_description.hpp"

namespace faster {

/// What cannot be timed, or would be timed wrongly, whatever the configuration: names that are used twice, parts that
/// are named and not there, an end of a FIFO that several modules have. Errors: InputError.
void check_design(CoreDescription const& core);

}  // namespace faster
