#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "faster/workload_config.hpp"

namespace faster {

/// The value of one configuration key, in the types JSON has. Choices and paths are text; three numbers (a translation
/// or rotation) and the scene's list of objects are the only compound values.
using KeyValue =
    std::variant<bool, std::int64_t, double, std::string, std::array<double, 3>, std::vector<SceneObjectConfig>>;

/// The value as JSON on one line, which is YAML as well. Numbers have just the digits that bring back the same value,
/// so two values are equal exactly if their texts are.
std::string json_text(KeyValue const& value);

}  // namespace faster
