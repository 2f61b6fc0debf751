#include "tb/sample_pictures.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "faster/data/sample_counters.hpp"
#include "faster/workload/files/png_image.hpp"
#include "faster/workload/pictures/contact_sheet.hpp"
#include "faster/workload/pictures/depth_map.hpp"
#include "faster/workload/pictures/drawing.hpp"
#include "faster/workload/pictures/overlay.hpp"

namespace faster {

namespace {

namespace fs = std::filesystem;

/// Window pixels are small: a picture for people has about 600 pixels a side.
Image<Colour> for_people(Image<Colour> const& picture) {
    constexpr int usual_side = 600;
    return pictures::enlarged(picture, std::max(1, usual_side / picture.width()));
}

/// FOLDER/sample_0007_edges.png
fs::path sample_picture(fs::path const& folder, std::size_t sample, char const* content) {
    return folder / fmt::format("sample_{:04}_{}.png", sample, content);
}

void write_maps(fs::path const& folder, std::size_t sample, SampleMaps const& maps) {
    files::write_png(sample_picture(folder, sample, "edges"), files::visible(maps.edge_map));
    files::write_png(sample_picture(folder, sample, "object"), files::visible(maps.object_map));
    files::write_png(sample_picture(folder, sample, "depth"), maps.depth_buffer);
}

/// Its own scale shows the most of a sample, and its picture does not depend on the others.
Image<Colour> depth_map_of(SampleMaps const& maps, int fraction_bits) {
    pictures::DepthScale scale(fraction_bits);
    scale.include(maps.depth_buffer);
    return pictures::with_scale_bar(for_people(pictures::depth_map(maps.depth_buffer, scale)), scale);
}

}  // namespace

void SamplePictures::write(fs::path const& folder, std::vector<SampleStatistics> const& samples) const {
    fs::create_directories(folder);
    for (auto const& [sample, maps] : all()) {
        write_maps(folder, sample, maps);
        files::write_colour_png(sample_picture(folder, sample, "overlay"), for_people(overlay_of(sample, maps)));
        files::write_colour_png(sample_picture(folder, sample, "depth_map"),
                                depth_map_of(maps, stimulus_.fraction.depth_buffer));
    }
    if (!all().empty())
        write_contact_sheet(folder / "contact_sheet.png", samples);
}

std::vector<report::ReportPicture> SamplePictures::for_report() const {
    std::vector<report::ReportPicture> pictures;
    for (auto const& [sample, maps] : all())
        pictures.push_back(
            {fmt::format(
                 "Sample {}: contour red, object green, observed edges blue, purple where the contour lies on one",
                 sample),
             files::colour_png(for_people(overlay_of(sample, maps)))});
    return pictures;
}

Image<Colour> SamplePictures::overlay_of(std::size_t sample, SampleMaps const& maps) const {
    return pictures::overlay(maps.edge_map, maps.object_map,
                             pictures::observed_edges_in_window(stimulus_, stimulus_.samples[sample]));
}

void SamplePictures::write_contact_sheet(fs::path const& file, std::vector<SampleStatistics> const& samples) const {
    pictures::DepthScale scale(stimulus_.fraction.depth_buffer);
    for (auto const& [sample, maps] : all())
        scale.include(maps.depth_buffer);
    pictures::ContactSheet sheet(all().size(), scale);
    for (auto const& [sample, maps] : all())
        if (sheet.room() > 0)
            sheet.add(sample, counters_from(samples[sample].counters).inlier, overlay_of(sample, maps),
                      maps.depth_buffer);
    files::write_colour_png(file, sheet.picture());
}

}  // namespace faster
