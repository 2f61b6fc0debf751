#pragma once

namespace dataflow {

/// The process's exit codes (docs/formats.md#exit-codes).
enum ExitCode : int { exit_done = 0, exit_failed_check = 1, exit_bad_input = 2, exit_deadlock = 3 };

}  // namespace dataflow
