#pragma once
#include <cstddef>
#include <functional>
#include <optional>

namespace faster::sizing {

/// Something that holds for the first of some numbers, and for all up to one.
struct Monotone {
    std::function<bool(std::size_t)> holds;
    std::function<std::optional<bool>(std::size_t)> is_known_to_hold;  ///< without working it out
    /// By how much it holds, negative where it does not, if that has been worked out. Never rises.
    std::function<std::optional<double>(std::size_t)> known_margin = [](std::size_t) { return std::nullopt; };
    /// What the margin bends little over. Rises.
    std::function<double(std::size_t)> place = [](std::size_t i) { return static_cast<double>(i); };
};

/// The last of 0 .. count - 1 for which it holds, as for 0. Tries as many at once as there are jobs: near 0, where most
/// searches end, then where lines through known margins lead to none, or evenly where that did not help.
std::size_t last_that_holds(std::size_t count, unsigned jobs, Monotone const& monotone);

}  // namespace faster::sizing
