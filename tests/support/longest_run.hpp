#pragma once

namespace faster::test {

/// A process that a test starts is ended by SIGALRM after so long, so that a hang is a failure of that test alone.
inline constexpr unsigned longest_run_seconds = 120;

}  // namespace faster::test
