#pragma once
#include <string>
#include <vector>

#include "kernel/budgets/evaluate.hpp"
#include "kernel/budgets/explain.hpp"

namespace faster::budgets {

/// How one budget fared.
struct CheckResult {
    enum class Status {
        passed,
        breached,    ///< a figure is outside its limit
        deadlocked,  ///< the run got stuck; `message` says who waits for whom
        timed_out,   ///< the simulation reached its time limit
        crashed,     ///< the simulation ended without a result
        bad,         ///< the budget or its configuration is at fault; `message` is the one line to print
    };
    std::string name;
    std::string file;
    Status status = Status::passed;
    std::string message;
    std::vector<Verdict> verdicts;
    Explanation explanation;    ///< since the baseline
    std::string baseline_date;  ///< and reason: of the baseline that it explains against; empty if there is none
    std::string baseline_reason;
    std::string updated;  ///< what --update did, for people
    double seconds = 0;   ///< of the host

    bool is_failure() const { return status != Status::passed; }
};

/// "passed", "breached", ...
char const* name_of(CheckResult::Status status);

}  // namespace faster::budgets
