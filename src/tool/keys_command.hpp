#pragma once
#include "tool/subcommand.hpp"

namespace faster {

/// `keys`.
Subcommand keys_command();

}  // namespace faster
