#pragma once
#include <string>
#include <vector>

#include "dataflow/tools/budgets/budget.hpp"
#include "dataflow/tools/budgets/evaluate.hpp"
#include "dataflow/tools/budgets/measurement.hpp"
#include "dataflow/tools/compare/comparison.hpp"

namespace dataflow::budgets {

/// What moved since the baseline. Work does not depend on time in this machine, so a change of shape or work is where
/// a breach starts, and a change of waiting is what follows from it - or, alone, from something that no figure counts.
struct Explanation {
    bool same_configuration = true;             ///< by its hash
    std::vector<runs::SettingChange> settings;  ///< keys of the accelerator
    std::vector<runs::Change> shapes;           ///< depths, capacities, intervals, ports
    std::vector<runs::Change> work;     ///< busy, fill and drain, setup, conflicts, recurrences; tokens, iterations
    std::vector<runs::Change> waiting;  ///< stalls, idle cycles, occupancies
    std::vector<runs::Change> results;  ///< counters of samples, as far as the baseline has them

    bool is_empty() const {
        return same_configuration && shapes.empty() && work.empty() && waiting.empty() && results.empty();
    }
};

/// Compares the figures that the baseline has, all cores together; each list starts with the largest difference. A run
/// without figures (a deadlock) only has settings to compare.
Explanation explain(Baseline const& baseline, Measurement const& measurement);

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

}  // namespace dataflow::budgets
