#pragma once
#include "faster/dataflow_names.hpp"
#include "support/is_instrumented.hpp"

namespace faster::test {

/// A process that a test starts is ended by SIGALRM after so long, so that a hang is a failure of that test alone.
inline constexpr unsigned longest_run_seconds = is_instrumented ? 600 : 120;

}  // namespace faster::test
