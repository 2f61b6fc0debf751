#include <charconv>
#include <initializer_list>
#include <stdexcept>
#include <string>

#include "kernel/base/files/atomic_folder.hpp"
#include "kernel/base/files/text_file.hpp"
#include "workload/files/png_image.hpp"
#include "workload/files/trace.hpp"
#include "workload/files/trace_manifest.hpp"
#include "workload/files/trace_tables.hpp"

namespace faster::io {
namespace {

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

Image<std::uint8_t> visible(Image<std::uint8_t> edges) {
    for (std::uint8_t& pixel : edges.pixels()) {
        pixel = pixel == 0 ? 0 : 255;
    }
    return edges;
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

FolderKind const& trace_kind() {
    static TraceManifest::Files const files;
    static FolderKind const kind{
        "stimulus trace", TraceManifest::file_name, {files.samples, files.triangles, files.depth, files.edges}};
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

}  // namespace faster::io
