#include "faster/workload/pictures/depth_map.hpp"

#include <algorithm>
#include <cmath>

#include "faster/workload/pictures/colour.hpp"
#include "faster/workload/pictures/drawing.hpp"

namespace faster::pictures {

namespace {

/// Measures of a scale bar beside a picture of this height [px].
struct BarLayout {
    explicit BarLayout(int picture_height) : unit(std::max(1.0, picture_height / 600.0)), height(picture_height) {
        bar = {margin(), margin(), height - 2 * margin(), px(22)};
    }
    int px(double length) const { return static_cast<int>(std::lround(length * unit)); }
    int margin() const { return px(20); }
    int ticks_left() const { return bar.left + bar.width; }
    int labels_left() const { return ticks_left() + px(10); }
    int width() const { return labels_left() + px(90); }
    double text_scale() const { return 0.5 * unit; }

    double unit;  // 1 for the usual 600 px
    int height;
    Box bar;
};

void draw_bar(Image<Colour>& canvas, BarLayout const& layout) {
    for (int row = 0; row < layout.bar.height; ++row) {
        int const shade = row * (DepthScale::shades - 1) / std::max(1, layout.bar.height - 1);
        fill(canvas, {layout.bar.top + row, layout.bar.left, 1, layout.bar.width}, viridis(shade));
    }
}

void draw_ticks(Image<Colour>& canvas, BarLayout const& layout, DepthScale const& scale) {
    for (double const depth : scale.ticks()) {
        double const below = std::clamp(scale.position(depth), 0.0, 1.0) * (layout.bar.height - 1);
        int const row = layout.bar.top + static_cast<int>(std::lround(below));
        fill(canvas, {row, layout.ticks_left(), layout.px(1), layout.px(5)}, palette::ink);
        write_text(canvas, scale.label(depth), row + layout.px(5), layout.labels_left(), layout.text_scale());
    }
}

Image<Colour> scale_bar(int height, DepthScale const& scale) {
    BarLayout const layout(height);
    Image<Colour> strip(height, layout.width(), palette::paper);
    if (scale.has_depths()) {
        draw_bar(strip, layout);
        draw_ticks(strip, layout, scale);
    } else {
        write_text(strip, "nothing drawn", height / 2, layout.px(8), layout.text_scale());
    }
    return strip;
}

}  // namespace

Image<Colour> depth_map(Image<std::uint16_t> const& depth_buffer, DepthScale const& scale) {
    Image<Colour> picture(depth_buffer.height(), depth_buffer.width());
    std::transform(depth_buffer.pixels().begin(), depth_buffer.pixels().end(), picture.pixels().begin(),
                   [&scale](std::uint16_t code) { return scale.colour(code); });
    return picture;
}

Image<Colour> with_scale_bar(Image<Colour> const& picture, DepthScale const& scale) {
    Image<Colour> const bar = scale_bar(picture.height(), scale);
    Image<Colour> canvas(picture.height(), picture.width() + bar.width());
    paste(canvas, picture, 0, 0);
    paste(canvas, bar, 0, picture.width());
    return canvas;
}

}  // namespace faster::pictures
