#include "kernel/budgets/check_result.hpp"

namespace faster::budgets {

char const* name_of(CheckResult::Status status) {
    switch (status) {
        case CheckResult::Status::passed:
            return "passed";
        case CheckResult::Status::breached:
            return "breached";
        case CheckResult::Status::deadlocked:
            return "deadlocked";
        case CheckResult::Status::timed_out:
            return "timed_out";
        case CheckResult::Status::crashed:
            return "crashed";
        case CheckResult::Status::bad:
            return "bad";
    }
    return "";
}

}  // namespace faster::budgets
