#pragma once
#include <cstdint>

#include "chance/chance_design.hpp"

namespace faster::chance {

/// A design of functions over hls::stream whose accesses wait, with the timing that docs/hls.md gives them. A seed
/// always gives one.
Design random_functions(std::uint64_t seed);

}  // namespace faster::chance
