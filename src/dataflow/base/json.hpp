#pragma once
#include <nlohmann/json.hpp>

namespace dataflow {

/// Keeps its keys in the order in which they were added, so that files read as they were written.
using Json = nlohmann::ordered_json;

}  // namespace dataflow
