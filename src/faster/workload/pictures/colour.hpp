#pragma once
#include <array>
#include <cstdint>

namespace faster {

/// Red, green, blue.
using Colour = std::array<std::uint8_t, 3>;

}  // namespace faster

namespace faster::pictures::palette {

// Red, green and blue are those of the thesis's figures 4.3 and 4.4.
constexpr Colour edge_map{215, 25, 28};
constexpr Colour object_map{150, 215, 140};
constexpr Colour observed_edges{43, 91, 200};
constexpr Colour edge_on_observed_edge{150, 20, 190};
constexpr Colour paper{255, 255, 255};
constexpr Colour ink{30, 30, 30};
constexpr Colour nothing_drawn{190, 190, 190};  ///< in a depth map; no colour of its scale is grey

constexpr Colour grid{222, 222, 222};

/// Lines of a plot, one after the other: told apart also by those who see no red or no green (Okabe and Ito, 2008).
constexpr std::array<Colour, 7> lines{
    {{0, 114, 178}, {213, 94, 0}, {0, 158, 115}, {204, 121, 167}, {86, 180, 233}, {230, 159, 0}, {90, 90, 90}}};

}  // namespace faster::pictures::palette
