#include "tb/run_folder.hpp"

#include <fmt/format.h>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "kernel/base/files/csv_integers.hpp"
#include "kernel/base/files/text_file.hpp"
#include "kernel/base/input_error.hpp"
#include "workload/files/png_image.hpp"
#include "workload/files/sample_picture.hpp"

namespace faster {

namespace {

namespace fs = std::filesystem;

constexpr std::int64_t any = std::numeric_limits<std::int64_t>::max();

/// Samples are numbered from 0: "0", "0..5".
std::string range_text(std::size_t count) {
    return count < 2 ? (count == 0 ? "no sample at all" : "0") : fmt::format("0..{}", count - 1);
}

/// In the place of what was to be a folder.
std::string what_is_there(fs::path const& file) {
    std::error_code ignored;
    return fs::exists(file, ignored) ? "is a file" : "no such folder";
}

template <class Pixel>
void require_size_of_edges(fs::path const& file, Image<Pixel> const& found, Image<std::uint8_t> const& edges) {
    io::require_size(file, found.width(), found.height(), edges.width(), edges.height(), "the size of the edge map");
}

bool is_folder(fs::path const& folder) {
    std::error_code ignored;
    return fs::is_directory(folder, ignored);
}

}  // namespace

RunFolder::RunFolder(fs::path folder) : folder_(std::move(folder)), images_(folder_ / "images") {
    if (!is_folder(folder_))
        throw InputError(fmt::format("{}: {}, expected the results of a run; {}", folder_.string(),
                                     what_is_there(folder_), how_to_make(1)));
    if (!is_folder(images_))
        throw InputError(fmt::format("{}: {}, expected pictures of a run; {}", images_.string(), what_is_there(images_),
                                     how_to_make(1)));
    if (pictured_samples() == 0)
        throw InputError(fmt::format("{}: no picture in it, expected sample_NNNN_{{edges,object,depth}}.png; {}",
                                     images_.string(), how_to_make(1)));
}

std::string RunFolder::how_to_make(std::size_t images) const {
    return fmt::format("faster-sim run CONFIG --out {} --images {} writes them", folder_.string(), images);
}

std::size_t RunFolder::samples() const {
    std::size_t rows = 0;
    io::read_csv_integers(folder_ / "samples.csv", {{"sample", 0, any}},
                          [&rows](std::size_t, std::int64_t const*) { ++rows; });
    return rows;
}

/// A run writes pictures of its first samples.
std::size_t RunFolder::pictured_samples() const {
    std::size_t count = 0;
    while (fs::exists(io::sample_picture(images_, count, "edges")))
        ++count;
    return count;
}

void RunFolder::require_pictures_of(std::size_t sample) const {
    if (std::size_t const count = samples(); sample >= count)
        throw InputError(fmt::format("--sample {}: no row of it in {}, expected {}; {}", sample,
                                     (folder_ / "samples.csv").string(), range_text(count), how_to_make(count)));
    if (std::size_t const count = pictured_samples(); sample >= count)
        throw InputError(fmt::format("--sample {}: no picture of it in {}, expected {}; {}", sample, images_.string(),
                                     range_text(count), how_to_make(sample + 1)));
}

SampleMaps RunFolder::maps(std::size_t sample) const {
    require_pictures_of(sample);
    SampleMaps maps;
    maps.edge_map = io::read_png8(picture(sample, "edges"));
    maps.object_map = io::read_png8(picture(sample, "object"));
    maps.depth_buffer = io::read_png16(picture(sample, "depth"));
    require_size_of_edges(picture(sample, "object"), maps.object_map, maps.edge_map);
    require_size_of_edges(picture(sample, "depth"), maps.depth_buffer, maps.edge_map);
    return maps;
}

fs::path RunFolder::picture(std::size_t sample, std::string const& content) const {
    fs::path file = io::sample_picture(images_, sample, content);
    if (!fs::exists(file))
        throw InputError(
            fmt::format("{}: no such file, expected a picture of a run; {}", file.string(), how_to_make(sample + 1)));
    return file;
}

SampleFigures RunFolder::figures(std::size_t sample) const {
    std::vector<io::CsvColumn> const columns{{"sample", 0, any}, {"core", 0, any},       {"latency_cycles", 0, any},
                                             {"inlier", 0, any}, {"valid_edge", 0, any}, {"edge_inlier", 0, any}};
    SampleFigures figures;
    bool found = false;
    io::read_csv_integers(folder_ / "samples.csv", columns, [&](std::size_t, std::int64_t const* row) {
        if (row[0] == static_cast<std::int64_t>(sample)) {
            figures = {row[1], row[2], row[3], row[4], row[5]};
            found = true;
        }
    });
    if (!found)
        throw InputError(fmt::format("{}: no row of sample {}, expected one; {}", (folder_ / "samples.csv").string(),
                                     sample, how_to_make(sample + 1)));
    return figures;
}

int RunFolder::depth_fraction_bits() const {
    fs::path const file = folder_ / "summary.json";
    std::string const key = "accelerator.fraction_bits.depth_buffer";
    try {
        return nlohmann::json::parse(io::read_file(file)).at("configuration").at(key).at("value").get<int>();
    } catch (nlohmann::json::exception const&) {
        throw InputError(fmt::format("{}: no configuration with {}, expected the summary of a run; {}", file.string(),
                                     key, how_to_make(1)));
    }
}

}  // namespace faster
