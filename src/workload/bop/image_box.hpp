#pragma once
#include "workload/bop/dataset.hpp"
#include "workload/bop/json_node.hpp"

namespace faster::bop {

/// A box [x, y, width, height] of a JSON file. Throws InputError, also for a negative size.
ImageBox read_box(JsonNode const& node);

}  // namespace faster::bop
