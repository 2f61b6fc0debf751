#pragma once
#include <cstdint>

#include "dataflow/tools/sweeps/sweep.hpp"
#include "dataflow/tools/sweeps/value_lists.hpp"

namespace dataflow::sweeps {

/// `count` independent draws of the keys of `random`, a map from keys to {range: [2, 64]}, {log_range: [2, 64]} or
/// {choices: [...]}. A larger count only adds rows. Without rows if something is wrong.
Dimension random_dimension(MapEntry const& random, std::int64_t count, std::uint64_t seed, ValueLists const& lists);

}  // namespace dataflow::sweeps
