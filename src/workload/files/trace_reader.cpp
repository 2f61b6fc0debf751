#include <fmt/format.h>

#include "kernel/base/input_error.hpp"
#include "workload/files/png_image.hpp"
#include "workload/files/trace.hpp"
#include "workload/files/trace_manifest.hpp"
#include "workload/files/trace_tables.hpp"

namespace faster::io {
namespace {

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

[[noreturn]] void fail_pixel(fs::path const& path, int row, int column, int found, std::string const& expected) {
    throw InputError(
        fmt::format("{}: pixel at row {}, column {} is {}, expected {}", path.string(), row, column, found, expected));
}

Image<std::uint16_t> read_depth(fs::path const& path, TraceManifest const& manifest) {
    Image<std::uint16_t> depth = read_png16(path);
    require_size(path, depth.width(), depth.height(), manifest.width, manifest.height, "trace.yaml");
    for (int row = 0; row < depth.height(); ++row) {
        for (int column = 0; column < depth.width(); ++column) {
            if (depth.at(row, column) > far_depth_code) {
                fail_pixel(path, row, column, depth.at(row, column), fmt::format("at most {}, far", far_depth_code));
            }
        }
    }
    return depth;
}

Image<std::uint8_t> read_edges(fs::path const& path, TraceManifest const& manifest) {
    Image<std::uint8_t> edges = read_png8(path);
    require_size(path, edges.width(), edges.height(), manifest.width, manifest.height, "trace.yaml");
    for (int row = 0; row < edges.height(); ++row) {
        for (int column = 0; column < edges.width(); ++column) {
            std::uint8_t& pixel = edges.at(row, column);
            if (pixel != 0 && pixel != 255) {
                fail_pixel(path, row, column, pixel, "0 or 255");
            }
            pixel = pixel == 0 ? 0 : 1;
        }
    }
    return edges;
}

}  // namespace

Stimulus read_trace(fs::path const& folder) {
    std::error_code ignored;
    if (!fs::is_directory(folder, ignored)) {
        throw InputError(fmt::format("{}: no such folder, expected a stimulus trace", folder.string()));
    }
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

}  // namespace faster::io
