#include "faster/workload/pictures/contact_sheet.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <string>

#include "faster/workload/pictures/colour.hpp"
#include "faster/workload/pictures/depth_map.hpp"
#include "faster/workload/pictures/drawing.hpp"

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

/// What the colours of overlay and depth map mean, `width` pixels wide and as high as it takes. The last thing
/// it says is `note`, if not empty. Text that does not fit into 400 px is cut off.
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

constexpr int largest_thumb = 200;
constexpr int smallest_thumb = 40;

/// Columns that make the cells an area about as wide as 4 : 3.
int columns_for(ContactLayout const& layout) {
    double const cell_ratio = static_cast<double>(layout.cell_height()) / layout.cell_width();
    double const columns = std::sqrt(static_cast<double>(layout.cells) * cell_ratio * 4 / 3);
    int const fitting = ContactLayout::longest_side / layout.cell_width();
    return static_cast<int>(std::clamp<double>(std::ceil(columns), 1, fitting));
}

std::size_t most_cells(ContactLayout const& layout) {
    int const columns = ContactLayout::longest_side / layout.cell_width();
    int const rows = ContactLayout::longest_side / layout.cell_height();
    return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
}

constexpr double text_scale = 0.42;

std::string note_on(std::size_t shown, std::size_t samples) {
    return shown == samples ? "" : fmt::format("the first {} of {} samples", shown, samples);
}

/// The longest text that fits above a cell's pictures.
std::string label_of(std::size_t sample, std::uint64_t inliers, int width) {
    std::string const full = fmt::format("sample {}: {} inliers", sample, inliers);
    return text_width(full, text_scale) <= width ? full : fmt::format("{}: {}", sample, inliers);
}

/// White pictures need a border on white paper.
void paste_framed(Image<Colour>& canvas, Image<Colour> const& picture, int top, int left) {
    fill(canvas, {top - 1, left - 1, picture.height() + 2, picture.width() + 2}, palette::nothing_drawn);
    paste(canvas, picture, top, left);
}

}  // namespace

ContactLayout contact_layout(std::size_t cells) {
    ContactLayout layout;
    layout.thumb = smallest_thumb;
    layout.cells = std::min(cells, most_cells(layout));
    for (layout.thumb = largest_thumb; layout.thumb >= smallest_thumb; --layout.thumb) {
        layout.columns = columns_for(layout);
        if (layout.height() <= ContactLayout::longest_side)
            return layout;
    }
    layout.thumb = smallest_thumb;
    layout.columns = ContactLayout::longest_side / layout.cell_width();
    return layout;
}

ContactSheet::ContactSheet(std::size_t samples, DepthScale const& scale)
    : scale_(scale), layout_(contact_layout(samples)) {
    Image<Colour> const top = legend(layout_.width(), scale, note_on(layout_.cells, samples));
    header_ = top.height();
    canvas_ = Image<Colour>(header_ + layout_.height(), layout_.width(), palette::paper);
    paste(canvas_, top, 0, 0);
}

void ContactSheet::add(std::size_t sample, std::uint64_t inliers, Image<Colour> const& overlay,
                       Image<std::uint16_t> const& depth_buffer) {
    constexpr int gap = ContactLayout::gap;
    int const top = header_ + layout_.cell_top(used_);
    int const left = layout_.cell_left(used_) + gap;
    int const below_label = top + ContactLayout::label;
    write_text(canvas_, label_of(sample, inliers, 2 * layout_.thumb + gap), below_label - 6, left, text_scale);
    paste_framed(canvas_, fitted_square(overlay, layout_.thumb), below_label, left);
    paste_framed(canvas_, fitted_square(depth_map(depth_buffer, scale_), layout_.thumb), below_label,
                 left + layout_.thumb + gap);
    ++used_;
}

}  // namespace faster::pictures
