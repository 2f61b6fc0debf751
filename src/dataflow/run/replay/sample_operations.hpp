#pragma once
#include <vector>

#include "dataflow/core/time/operation.hpp"

namespace dataflow::replay {

/// What each process of a core does for one sample, from where it begins the sample to where it begins the next, in
/// program order. By process.
using SampleOperations = std::vector<std::vector<timing::Operation>>;

}  // namespace dataflow::replay
