#include "faster/workload/pictures/terminal_picture.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <string_view>

#include "faster/data/fixed_point.hpp"
#include "faster/workload/pictures/colour.hpp"

namespace faster::pictures {

namespace {

Mark const& stronger(Mark const& a, Mark const& b) { return a.rank >= b.rank ? a : b; }

Mark contour_mark(bool is_edge, bool is_object) {
    if (is_edge)
        return {2, '#', palette::edge_map};
    return is_object ? Mark{1, '.', palette::object_map} : Mark{};
}

Mark depth_mark(std::uint16_t code, DepthScale const& scale) {
    if (code >= far_depth_code)
        return {};
    constexpr std::string_view near_to_far = "@%#*+=-:.";
    int const shade = scale.shade(code);
    auto const letter = static_cast<std::size_t>(shade) * near_to_far.size() / DepthScale::shades;
    return {DepthScale::shades - shade, near_to_far[letter], scale.colour(code)};
}

Image<Mark> doubled(Image<Mark> const& marks) {
    Image<Mark> large(2 * marks.height(), 2 * marks.width());
    for (int row = 0; row < large.height(); ++row)
        for (int col = 0; col < large.width(); ++col)
            large.at(row, col) = marks.at(row / 2, col / 2);
    return large;
}

/// Every mark falls on exactly one place, so thin lines stay thin and none gets lost.
Image<Mark> shrunk(Image<Mark> const& marks, int height, int width) {
    double const ratio =
        std::min(static_cast<double>(height) / marks.height(), static_cast<double>(width) / marks.width());
    auto const length = [ratio](int whole) { return std::max(1, static_cast<int>(whole * ratio)); };
    Image<Mark> small(length(marks.height()), length(marks.width()));
    for (int row = 0; row < marks.height(); ++row)
        for (int col = 0; col < marks.width(); ++col) {
            Mark& place = small.at(row * small.height() / marks.height(), col * small.width() / marks.width());
            place = stronger(place, marks.at(row, col));
        }
    return small;
}

/// The mark below; nothing after an odd last row.
Mark lower_mark(Image<Mark> const& marks, int row, int col) {
    return row + 1 < marks.height() ? marks.at(row + 1, col) : Mark{};
}

std::string without_trailing_blanks(std::string line) {
    line.erase(line.find_last_not_of(' ') + 1);
    return line;
}

std::string foreground(Colour c) { return fmt::format("38;2;{};{};{}", c[0], c[1], c[2]); }
std::string background(Colour c) { return fmt::format("48;2;{};{};{}", c[0], c[1], c[2]); }

/// Nothing, or a half-block and the escape sequence for its colours.
struct HalfBlock {
    std::string colours;
    char const* text = " ";
};

HalfBlock half_block(Mark const& upper, Mark const& lower) {
    if (upper.rank > 0 && lower.rank > 0)
        return {"\033[" + foreground(upper.colour) + ";" + background(lower.colour) + "m", "▀"};
    if (upper.rank > 0)
        return {"\033[0;" + foreground(upper.colour) + "m", "▀"};
    if (lower.rank > 0)
        return {"\033[0;" + foreground(lower.colour) + "m", "▄"};
    return {"\033[0m", " "};
}

std::string coloured_line(Image<Mark> const& marks, int row) {
    std::string line;
    std::string const no_colours = "\033[0m";
    std::string current = no_colours;
    for (int col = 0; col < marks.width(); ++col) {
        HalfBlock const block = half_block(marks.at(row, col), lower_mark(marks, row, col));
        if (block.colours != current)
            line += block.colours;
        line += block.text;
        current = block.colours;
    }
    return line + (current == no_colours ? "" : no_colours);
}

}  // namespace

Image<Mark> contour_marks(Image<std::uint8_t> const& edge_map, Image<std::uint8_t> const& object_map) {
    Image<Mark> marks(edge_map.height(), edge_map.width());
    for (int row = 0; row < marks.height(); ++row)
        for (int col = 0; col < marks.width(); ++col)
            marks.at(row, col) = contour_mark(edge_map.at(row, col) != 0, object_map.at(row, col) != 0);
    return marks;
}

Image<Mark> depth_marks(Image<std::uint16_t> const& depth_buffer, DepthScale const& scale) {
    Image<Mark> marks(depth_buffer.height(), depth_buffer.width());
    std::transform(depth_buffer.pixels().begin(), depth_buffer.pixels().end(), marks.pixels().begin(),
                   [&scale](std::uint16_t code) { return depth_mark(code, scale); });
    return marks;
}

Image<Mark> cropped(Image<Mark> const& marks) {
    int top = marks.height(), left = marks.width(), bottom = -1, right = -1;
    for (int row = 0; row < marks.height(); ++row)
        for (int col = 0; col < marks.width(); ++col)
            if (marks.at(row, col).rank > 0) {
                top = std::min(top, row), bottom = std::max(bottom, row);
                left = std::min(left, col), right = std::max(right, col);
            }
    if (bottom < 0)
        return {};
    Image<Mark> part(bottom - top + 1, right - left + 1);
    for (int row = 0; row < part.height(); ++row)
        std::copy_n(marks.row(top + row) + left, part.width(), part.row(row));
    return part;
}

Image<Mark> fitted_to_terminal(Image<Mark> const& marks, int height, int width) {
    if (marks.height() > height || marks.width() > width)
        return shrunk(marks, height, width);
    return 2 * marks.height() <= height && 2 * marks.width() <= width ? doubled(marks) : marks;
}

std::string plain_text(Image<Mark> const& marks) {
    std::string text;
    for (int row = 0; row < marks.height(); row += 2) {
        std::string line;
        for (int col = 0; col < marks.width(); ++col)
            line += stronger(marks.at(row, col), lower_mark(marks, row, col)).letter;
        text += without_trailing_blanks(line) + '\n';
    }
    return text;
}

std::string coloured_text(Image<Mark> const& marks) {
    std::string text;
    for (int row = 0; row < marks.height(); row += 2)
        text += coloured_line(marks, row) + '\n';
    return text;
}

}  // namespace faster::pictures
