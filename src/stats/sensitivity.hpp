#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "common/cycles.hpp"

namespace faster {

/// What one step of a timing key does to total_cycles, all else equal.
struct SensitivityStep {
    bool valid = false;  ///< the configuration allows it
    bool deadlocks = false;
    Cycles total_cycles = 0;  ///< if valid and not deadlocked
};

/// One timing key, a step down and a step up.
struct Sensitivity {
    std::string key;
    std::int64_t value = 0;
    SensitivityStep down;  ///< value - 1
    SensitivityStep up;    ///< value + 1
};

}  // namespace faster
