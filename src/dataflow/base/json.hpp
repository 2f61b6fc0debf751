#pragma once
#include <nlohmann/json.hpp>
#include <optional>

namespace dataflow {

/// Keeps its keys in the order in which they were added, so that files read as they were written.
using Json = nlohmann::ordered_json;

template <class Value> Json or_null(std::optional<Value> const& value) { return value ? Json(*value) : Json(); }

}  // namespace dataflow
