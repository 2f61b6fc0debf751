#include "workload/pictures/contact_sheet.hpp"

#include <fmt/format.h>
#include <string>

#include "workload/pictures/depth_map.hpp"
#include "workload/pictures/drawing.hpp"
#include "workload/pictures/legend.hpp"
#include "workload/pictures/palette.hpp"

namespace faster::pictures {

namespace {

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
