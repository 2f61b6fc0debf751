#pragma once
#include <nlohmann/json.hpp>

namespace faster {

/// Keeps its keys in the order in which they were added, so that files read as they were written.
using Json = nlohmann::ordered_json;

}  // namespace faster
