#include "tb/sample_pictures.hpp"

#include <fmt/format.h>

#include "datapath/edge_maps.hpp"
#include "io/png_image.hpp"

namespace faster {

namespace {

constexpr std::uint8_t lit = 255;

Image<std::uint8_t> picture_of(std::uint8_t const* map, int side) {
    Image<std::uint8_t> picture(side, side);
    for (std::uint8_t& pixel : picture.pixels())
        pixel = *map++ != 0 ? lit : std::uint8_t{0};
    return picture;
}

}  // namespace

void SamplePictures::edge_maps_done(std::size_t sample, datapath::EdgeMaps const& maps) {
    if (sample >= count_)
        return;
    maps_[sample].edge_map = picture_of(maps.edge(), maps.side());
    maps_[sample].object_map = picture_of(maps.object(), maps.side());
}

void SamplePictures::depth_buffer_done(std::size_t sample, std::vector<std::uint16_t> const& depth_buffer) {
    if (sample >= count_)
        return;
    Image<std::uint16_t> picture(stimulus_.window, stimulus_.window);
    picture.pixels() = depth_buffer;
    maps_[sample].depth_buffer = std::move(picture);
}

void SamplePictures::write(std::filesystem::path const& folder) const {
    std::filesystem::create_directories(folder);
    for (auto const& [sample, maps] : maps_) {
        std::string const name = fmt::format("sample_{:04}", sample);
        io::write_png(folder / (name + "_edges.png"), maps.edge_map);
        io::write_png(folder / (name + "_object.png"), maps.object_map);
        io::write_png(folder / (name + "_depth.png"), maps.depth_buffer);
        io::write_colour_png(folder / (name + "_overlay.png"), overlay_of(sample, maps));
    }
}

std::vector<report::ReportPicture> SamplePictures::for_report() const {
    std::vector<report::ReportPicture> pictures;
    for (auto const& [sample, maps] : maps_)
        pictures.push_back({fmt::format("Sample {}: contour red, object green, observed edges blue", sample),
                            io::colour_png(overlay_of(sample, maps))});
    return pictures;
}

Image<io::Colour> SamplePictures::overlay_of(std::size_t sample, SampleMaps const& maps) const {
    constexpr int zoom = 3;
    SampleInput const& input = stimulus_.samples[sample];
    int const side = stimulus_.window;
    Image<io::Colour> picture(side * zoom, side * zoom, {lit, lit, lit});
    for (int row = 0; row < side * zoom; ++row)
        for (int col = 0; col < side * zoom; ++col) {
            int const r = row / zoom, c = col / zoom;
            std::int64_t const image_row = std::int64_t{input.centre_row} - side / 2 + r;
            std::int64_t const image_col = std::int64_t{input.centre_col} - side / 2 + c;
            bool const on_image =
                image_row >= 0 && image_row < stimulus_.height && image_col >= 0 && image_col < stimulus_.width;
            if (maps.edge_map.at(r, c) != 0)
                picture.at(row, col) = {215, 25, 28};
            else if (on_image &&
                     stimulus_.observed_edges.at(static_cast<int>(image_row), static_cast<int>(image_col)) != 0)
                picture.at(row, col) = {43, 91, 200};
            else if (maps.object_map.at(r, c) != 0)
                picture.at(row, col) = {150, 215, 140};
        }
    return picture;
}

}  // namespace faster
