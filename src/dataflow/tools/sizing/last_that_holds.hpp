#pragma once
#include <cstddef>
#include <functional>
#include <optional>

namespace dataflow::sizing {

/// Something that holds for the first of some numbers, and for all up to one.
struct Monotone {
    using IsObsolete = std::function<bool()>;
    using Holds = std::function<std::optional<bool>(std::size_t, IsObsolete const&)>;
    /// Works it out. May give up, with nothing, once it is obsolete: others have told.
    Holds holds;
    std::function<std::optional<bool>(std::size_t)> is_known_to_hold;  ///< without working it out
};

/// The last of 0 .. count - 1 for which it holds, as for 0. Each of the jobs always has a number to try: first near 0,
/// where many searches end, then in the middle of the widest gap that nobody tries.
std::size_t last_that_holds(std::size_t count, unsigned jobs, Monotone const& monotone);

/// For what need not be monotone: one of 0 .. count - 1 for which it holds, as for 0, but not for the next one,
/// if there is one. Which, depends on nothing but `holds`: not on the jobs, two of which have something to do.
std::size_t last_before_failing(std::size_t count, unsigned jobs, Monotone::Holds const& holds);

}  // namespace dataflow::sizing
