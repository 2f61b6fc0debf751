#include "workload/pictures/legend.hpp"

#include <fmt/format.h>
#include <vector>

#include "workload/pictures/drawing.hpp"
#include "workload/pictures/palette.hpp"

namespace faster::pictures {

namespace {

constexpr int line_height = 24;
constexpr int margin = 8;
constexpr int swatch = 14;
constexpr double letter_scale = 0.42;

/// A patch of colour and what it means.
struct LegendItem {
    Image<Colour> patch;
    std::string text;

    int width() const { return patch.width() + margin / 2 + text_width(text, letter_scale) + 2 * margin; }
};

LegendItem plain_item(Colour colour, std::string text) { return {{swatch, swatch, colour}, std::move(text)}; }

LegendItem scale_item(DepthScale const& scale) {
    constexpr int width = DepthScale::shades / 2;
    Image<Colour> bar(swatch, width);
    for (int col = 0; col < width; ++col)
        fill(bar, {0, col, swatch, 1}, viridis(2 * col));
    return {bar, fmt::format("depth {:.3f} to {:.3f} m", scale.nearest_metres(), scale.farthest_metres())};
}

std::vector<LegendItem> items_of(DepthScale const& scale, std::string const& note) {
    std::vector<LegendItem> items{plain_item(palette::edge_map, "edge map"),
                                  plain_item(palette::object_map, "object map"),
                                  plain_item(palette::observed_edges, "observed edge"),
                                  plain_item(palette::edge_on_observed_edge, "edge map on observed edge"),
                                  plain_item(palette::nothing_drawn, "nothing drawn")};
    if (scale.has_depths())
        items.push_back(scale_item(scale));
    if (!note.empty())
        items.push_back({{}, note});
    return items;
}

/// Where an item stands: left to right, then on the next line.
class Cursor {
  public:
    explicit Cursor(int width) : width_(width) {}
    void make_room(int item_width) {
        if (left_ > margin && left_ + item_width > width_) {
            left_ = margin;
            top_ += line_height;
        }
    }
    void advance(int item_width) { left_ += item_width; }
    int left() const { return left_; }
    int top() const { return top_; }

  private:
    int width_;
    int left_ = margin;
    int top_ = margin;
};

int lines_height(std::vector<LegendItem> const& items, int width) {
    Cursor cursor(width);
    for (LegendItem const& item : items) {
        cursor.make_room(item.width());
        cursor.advance(item.width());
    }
    return cursor.top() + line_height;
}

}  // namespace

Image<Colour> legend(int width, DepthScale const& scale, std::string const& note) {
    std::vector<LegendItem> const items = items_of(scale, note);
    Image<Colour> canvas(lines_height(items, width), width, palette::paper);
    Cursor cursor(width);
    for (LegendItem const& item : items) {
        cursor.make_room(item.width());
        paste(canvas, item.patch, cursor.top(), cursor.left());
        write_text(canvas, item.text, cursor.top() + swatch - 2, cursor.left() + item.patch.width() + margin / 2,
                   letter_scale);
        cursor.advance(item.width());
    }
    return canvas;
}

}  // namespace faster::pictures
