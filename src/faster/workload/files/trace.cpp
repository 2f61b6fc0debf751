#include "faster/workload/files/trace.hpp"

#include <charconv>
#include <cstdint>
#include <fmt/format.h>
#include <initializer_list>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "dataflow/base/files/atomic_folder.hpp"
#include "dataflow/base/files/csv_integers.hpp"
#include "dataflow/base/files/text_file.hpp"
#include "dataflow/base/input_error.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/workload/files/png_image.hpp"
#include "faster/workload/files/trace_manifest.hpp"

namespace faster::files {

namespace {

/// The columns of the two tables of a trace, in the order in which they are written, with the limits of the formats.
inline std::vector<CsvColumn> sample_columns() {
    std::int64_t const index_max = std::numeric_limits<std::uint32_t>::max();
    std::int64_t const pixel_min = std::numeric_limits<std::int32_t>::min();
    std::int64_t const pixel_max = std::numeric_limits<std::int32_t>::max();
    return {{"sample", 0, index_max},
            {"centre_row", pixel_min, pixel_max},
            {"centre_col", pixel_min, pixel_max},
            {"first_triangle", 0, index_max},
            {"triangle_count", 0, index_max}};
}

inline std::vector<CsvColumn> triangle_columns() {
    std::vector<CsvColumn> columns;
    for (char const* vertex : {"0", "1", "2"}) {
        columns.push_back({std::string("x") + vertex, -32768, 32767});
        columns.push_back({std::string("y") + vertex, -32768, 32767});
        columns.push_back({std::string("z") + vertex, 0, 65535});
    }
    return columns;
}

namespace fs = std::filesystem;

VertexCode vertex_from(std::int64_t const* xyz) {
    return {static_cast<std::int16_t>(xyz[0]), static_cast<std::int16_t>(xyz[1]), static_cast<std::uint16_t>(xyz[2])};
}

std::vector<TriangleCode> read_triangles(fs::path const& path) {
    std::vector<TriangleCode> triangles;
    read_csv_integers(path, triangle_columns(), [&](std::size_t, std::int64_t const* values) {
        triangles.push_back({{vertex_from(values), vertex_from(values + 3), vertex_from(values + 6)}});
    });
    return triangles;
}

/// The rules of samples.csv that concern more than one cell: numbered without gaps, triangles within their file.
/// Says what breaks them, or nothing.
std::string problem_with(std::int64_t sample, std::size_t expected_sample, std::int64_t triangles_end,
                         std::size_t triangles) {
    if (sample != static_cast<std::int64_t>(expected_sample)) {
        return fmt::format("sample = {}, expected {} (numbered from 0 without gaps)", sample, expected_sample);
    }
    if (triangles_end > static_cast<std::int64_t>(triangles)) {
        return fmt::format("first_triangle + triangle_count = {}, expected at most {} (the triangles of the trace)",
                           triangles_end, triangles);
    }
    return {};
}

std::vector<SampleInput> read_samples(fs::path const& path, std::size_t triangles) {
    std::vector<SampleInput> samples;
    read_csv_integers(path, sample_columns(), [&](std::size_t line, std::int64_t const* values) {
        std::string const problem = problem_with(values[0], samples.size(), values[3] + values[4], triangles);
        if (!problem.empty()) {
            throw InputError(fmt::format("{}:{}: {}", path.string(), line, problem));
        }
        samples.push_back({static_cast<std::int32_t>(values[1]), static_cast<std::int32_t>(values[2]),
                           static_cast<std::uint32_t>(values[3]), static_cast<std::uint32_t>(values[4])});
    });
    return samples;
}

template <class Pixel, class IsValid>
void require_pixels(fs::path const& path, Image<Pixel> const& image, TraceManifest const& manifest, IsValid is_valid,
                    std::string const& expected) {
    require_size(path, image.width(), image.height(), manifest.width, manifest.height, "trace.yaml");
    for (int row = 0; row < image.height(); ++row)
        for (int column = 0; column < image.width(); ++column)
            if (Pixel const pixel = image.at(row, column); !is_valid(pixel))
                throw InputError(fmt::format("{}: pixel at row {}, column {} is {}, expected {}", path.string(), row,
                                             column, pixel, expected));
}

Image<std::uint16_t> read_depth(fs::path const& path, TraceManifest const& manifest) {
    Image<std::uint16_t> depth = read_png16(path);
    require_pixels(
        path, depth, manifest, [](std::uint16_t code) { return code <= far_depth_code; },
        fmt::format("at most {}, far", far_depth_code));
    return depth;
}

Image<std::uint8_t> read_edges(fs::path const& path, TraceManifest const& manifest) {
    Image<std::uint8_t> edges = read_png8(path);
    require_pixels(
        path, edges, manifest, [](std::uint8_t pixel) { return pixel == 0 || pixel == 255; }, "0 or 255");
    for (std::uint8_t& pixel : edges.pixels())
        pixel = pixel == 0 ? 0 : 1;
    return edges;
}

std::string header(std::vector<CsvColumn> const& columns) {
    std::string line;
    for (auto const& column : columns) {
        line += (line.empty() ? "" : ",") + column.name;
    }
    return line + '\n';
}

void append_row(std::string& text, std::initializer_list<std::int64_t> values) {
    char digits[24];
    for (std::int64_t const value : values) {
        text.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
        text += ',';
    }
    text.back() = '\n';
}

std::string samples_text(std::vector<SampleInput> const& samples) {
    std::string text = header(sample_columns());
    std::int64_t index = 0;
    for (SampleInput const& sample : samples) {
        append_row(text, {index++, sample.centre_row, sample.centre_col, sample.first_triangle, sample.triangle_count});
    }
    return text;
}

std::string triangles_text(std::vector<TriangleCode> const& triangles) {
    std::string text = header(triangle_columns());
    for (TriangleCode const& triangle : triangles) {
        VertexCode const* const v = triangle.vertex;
        append_row(text, {v[0].x, v[0].y, v[0].z, v[1].x, v[1].y, v[1].z, v[2].x, v[2].y, v[2].z});
    }
    return text;
}

void require_writable(Stimulus const& stimulus) {
    auto const has_size = [&](auto const& image) {
        return image.width() == stimulus.width && image.height() == stimulus.height;
    };
    if (stimulus.is_posed() || !has_size(stimulus.observed_depth) || !has_size(stimulus.observed_edges)) {
        throw std::logic_error("write_trace: expected explicit triangles and images of the stimulus's size");
    }
}

}  // namespace

Stimulus read_trace(fs::path const& folder) {
    require_folder(folder, "a stimulus trace");
    TraceManifest const manifest = read_manifest(folder / TraceManifest::file_name);
    Stimulus stimulus;
    stimulus.width = manifest.width;
    stimulus.height = manifest.height;
    stimulus.window = manifest.window;
    stimulus.fraction = manifest.fraction;
    stimulus.triangles = read_triangles(folder / manifest.files.triangles);
    stimulus.samples = read_samples(folder / manifest.files.samples, stimulus.triangles.size());
    stimulus.observed_depth = read_depth(folder / manifest.files.depth, manifest);
    stimulus.observed_edges = read_edges(folder / manifest.files.edges, manifest);
    return stimulus;
}

FolderKind const& trace_kind() {
    static TraceManifest::Files const files;
    static FolderKind const kind{"stimulus trace",
                                 TraceManifest::file_name,
                                 {files.samples, files.triangles, files.depth, files.edges},
                                 TraceManifest::format};
    return kind;
}

void write_trace(Stimulus const& stimulus, std::filesystem::path const& folder) {
    require_writable(stimulus);
    TraceManifest const manifest{stimulus.width, stimulus.height, stimulus.window, stimulus.fraction, {}};
    AtomicFolder output(folder, trace_kind());
    write_file(output.path() / TraceManifest::file_name, manifest_text(manifest));
    write_file(output.path() / manifest.files.samples, samples_text(stimulus.samples));
    write_file(output.path() / manifest.files.triangles, triangles_text(stimulus.triangles));
    write_png(output.path() / manifest.files.depth, stimulus.observed_depth);
    write_png(output.path() / manifest.files.edges, visible(stimulus.observed_edges));
    output.commit();
}

}  // namespace faster::files
