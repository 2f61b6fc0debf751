#pragma once
#include "tool/check_command.hpp"

namespace faster {

/// `faster-sim check --init`: runs a configuration and writes a commented budget that this run keeps. Returns the exit
/// code; throws InputError, also if the file is there already.
int start_budget(CheckRequest const& request);

}  // namespace faster
