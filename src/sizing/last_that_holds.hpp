#pragma once
#include <cstddef>
#include <functional>
#include <optional>

namespace faster::sizing {

/// Something that holds for the first of some numbers, and for all up to one.
struct Monotone {
    std::function<bool(std::size_t)> holds;
    std::function<std::optional<bool>(std::size_t)> is_known_to_hold;  ///< without working it out
};

/// The last of 0 .. count - 1 for which it holds, as for 0. Tries as many at once as there are jobs: first near 0,
/// where many searches end, then evenly.
std::size_t last_that_holds(std::size_t count, unsigned jobs, Monotone const& monotone);

}  // namespace faster::sizing
