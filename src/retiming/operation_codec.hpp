#pragma once
#include <string>
#include <string_view>

#include "retiming/sample_operations.hpp"
#include "timing/core_timing.hpp"

namespace faster::retiming {

/// The operations of a sample as bytes (docs/formats.md, "Event files"): by process a table of the shapes that occur,
/// then columns, which compress better than whole operations do.
std::string encode(SampleOperations const& operations);

/// And back, for the processes of a core. False if the bytes say what none of its processes can do.
bool decode(std::string_view bytes, timing::CoreTiming const& core, SampleOperations& operations);

}  // namespace faster::retiming
