#pragma once
#include <cstdint>
#include <string>

#include "faster/data/image.hpp"
#include "faster/workload/pictures/colour.hpp"
#include "faster/workload/pictures/depth_scale.hpp"

namespace faster::pictures {

/// What stands at one place of a picture on a terminal. Where several pixels fall together, the greatest rank is seen.
struct Mark {
    int rank = 0;  ///< 0: nothing, the terminal's background
    char letter = ' ';
    Colour colour{};
};

/// Edge map ('#', red) over object map ('.', green).
Image<Mark> contour_marks(Image<std::uint8_t> const& edge_map, Image<std::uint8_t> const& object_map);

/// The depth buffer in the colours of a scale; in letters from '@' (near) to '.' (far).
Image<Mark> depth_marks(Image<std::uint16_t> const& depth_buffer, DepthScale const& scale);

/// The part in which there is something; empty if there is nothing.
Image<Mark> cropped(Image<Mark> const& marks);

/// At most `height` x `width` marks: two by two for each where they fit, else as it is or smaller.
Image<Mark> fitted_to_terminal(Image<Mark> const& marks, int height, int width);

/// Two marks per character, one above the other, because a character is about twice as high as it is wide. Lines end
/// in '\n' and not in blanks.
std::string plain_text(Image<Mark> const& marks);

/// Two marks per character in half-blocks with 24-bit colours (ANSI escape sequences, UTF-8).
std::string coloured_text(Image<Mark> const& marks);

}  // namespace faster::pictures
