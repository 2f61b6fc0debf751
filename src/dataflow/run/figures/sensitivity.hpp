#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "dataflow/base/cycles.hpp"

namespace dataflow {

/// Why a key has no more slack than it has.
enum class SlackEnd {
    costs,    ///< one more makes the run longer, or deadlock
    unknown,  ///< only a run can tell of one more
    invalid,  ///< the configuration does not allow one more
    limit,    ///< one more was not tried
};

/// The largest change of a timing key in one direction that costs nothing, all else equal.
struct Slack {
    std::int64_t change = 0;
    SlackEnd end = SlackEnd::costs;
};

/// What one step of a timing key does to total_cycles, all else equal.
struct SensitivityStep {
    bool valid = false;  ///< the configuration allows it
    bool deadlocks = false;
    Cycles total_cycles = 0;       ///< if valid, not deadlocked and known
    std::optional<Slack> slack{};  ///< in this direction, if asked for
    bool needs_run = false;        ///< which alone can tell: see NotRetimable
};

inline bool finishes(SensitivityStep const& step) { return step.valid && !step.deadlocks && !step.needs_run; }

/// One timing key, a step down and a step up.
struct Sensitivity {
    std::string key;
    std::int64_t value = 0;
    SensitivityStep down;  ///< value - 1
    SensitivityStep up;    ///< value + 1
};

/// What another value of a choice does to total_cycles, all else equal.
struct Alternative {
    std::string key;
    std::string value;
    std::string other;
    SensitivityStep step;  ///< always without slack
};

}  // namespace dataflow
