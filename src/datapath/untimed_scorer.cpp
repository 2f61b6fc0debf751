#include "datapath/untimed_scorer.hpp"

#include <algorithm>

#include "common/fixed_point.hpp"

namespace faster::datapath {

namespace {

ContourDepth contour_depth(EdgeMapAlgorithm algorithm) {
    return algorithm == EdgeMapAlgorithm::inner_border ? ContourDepth::own : ContourDepth::neighbour;
}

/// Token coordinates have 16 bits. No image is wider than 4096 pixels, so a window further off covers none of it either
/// way.
std::int64_t clamped_offset(std::int64_t offset) { return std::clamp<std::int64_t>(offset, -8192, 8192); }

/// Rows or columns [first, end) of a window that lie in the image.
struct Overlap {
    Overlap(std::int64_t offset, int side, int image_size)
        : first(static_cast<int>(std::clamp<std::int64_t>(-offset, 0, side))),
          end(static_cast<int>(std::clamp<std::int64_t>(image_size - offset, first, side))) {}
    int first;
    int end;
};

}  // namespace

UntimedScorer::UntimedScorer(Stimulus const& stimulus, EdgeMapConfig const& edge_map)
    : stimulus_(stimulus),
      edge_map_(edge_map),
      depth_unit_(stimulus.fraction),
      sweep_(stimulus.window, stimulus.fraction.depth_buffer, contour_depth(edge_map.algorithm)),
      maps_(make_edge_map_policy(edge_map.algorithm, stimulus.window)),
      depth_buffer_(static_cast<std::size_t>(stimulus.window) * static_cast<std::size_t>(stimulus.window)) {
    window_.side = stimulus.window;
}

SampleCounters UntimedScorer::score(Pose const& pose, SampleInput const& input) {
    window_.row = clamped_offset(std::int64_t{input.centre_row} - window_.side / 2);
    window_.col = clamped_offset(std::int64_t{input.centre_col} - window_.side / 2);
    maps_->clear();
    std::fill(depth_buffer_.begin(), depth_buffer_.end(), far_depth_code);
    tokens_.clear();
    vertices_.clear();
    for (Eigen::Vector3d const& point : stimulus_.posed.mesh.vertices)
        vertices_.push_back(project(point, pose, stimulus_.posed.camera, stimulus_.fraction));
    SampleCounters counters;
    for (auto const& face : stimulus_.posed.mesh.faces) {
        ProjectedVertex const& a = vertices_[face[0]];
        ProjectedVertex const& b = vertices_[face[1]];
        ProjectedVertex const& c = vertices_[face[2]];
        if (a.usable && b.usable && c.usable)
            draw({{a.code, b.code, c.code}}, counters);
    }
    build_edge_map();
    sweep(counters);
    return counters;
}

void UntimedScorer::draw(TriangleCode const& triangle, SampleCounters& counters) {
    TriangleSetup const setup =
        set_up(triangle, stimulus_.width, stimulus_.height, stimulus_.fraction.vertex_xy);
    if (!setup.drawn())
        return;
    std::uint64_t const reciprocal = reciprocal_of(setup.area, stimulus_.fraction);
    previous_inside_ = setup.starts_inside();
    previous_row_ = setup.start_row;
    previous_col_ = setup.start_col;
    ZigzagScan lines(setup);
    while (!lines.done()) {
        ScanLine const line = lines.next_line();
        if (line.inside > 0)
            draw_run(line, reciprocal, counters);
        add_tokens(line);
    }
}

/// The fragments of a line that lie in the window.
void UntimedScorer::draw_run(ScanLine const& line, std::uint64_t reciprocal, SampleCounters& counters) {
    std::int64_t const row = line.row - window_.row;
    if (row < 0 || row >= window_.side)
        return;
    std::int64_t col = line.col(line.before) - window_.col;
    std::int64_t z_sum = line.z_sum;
    std::uint16_t* const words = depth_buffer_.data() + row * window_.side;
    std::uint64_t drawn = 0;
    for (int i = 0; i < line.inside; ++i) {
        if (col >= 0 && col < window_.side) {
            std::uint64_t const depth = depth_unit_.fragment_depth(static_cast<std::uint64_t>(z_sum), reciprocal);
            drawn += depth_unit_.draw(depth, words[col]) ? 1U : 0U;
        }
        col += line.step;
        z_sum += line.z_sum_per_step;
    }
    counters.valid_raster += drawn;
}

/// Covered pixels are objects; the pixel behind a run is an edge, and so is the one before it, which is sent after the
/// run's first pixel unless the triangle ends there (A.1 loses it then).
void UntimedScorer::add_tokens(ScanLine const& line) {
    if (previous_inside_ && line.before > 0) {
        add_token(line.row, line.first_col, EdgeTokenKind::Edge);
        previous_inside_ = false;
    }
    if (line.before > 0) {
        previous_row_ = line.row;
        previous_col_ = line.col(line.before - 1);
    }
    if (line.inside > 0) {
        bool const ends_here = line.last && line.inside == 1 && line.after == 0;
        add_token(line.row, line.col(line.before), EdgeTokenKind::Object);
        if (!previous_inside_ && !ends_here)
            add_token(previous_row_, previous_col_, EdgeTokenKind::Edge);
        for (int i = 1; i < line.inside; ++i)
            add_token(line.row, line.col(line.before + i), EdgeTokenKind::Object);
        if (line.after > 0)
            add_token(line.row, line.col(line.before + line.inside), EdgeTokenKind::Edge);
        previous_inside_ = line.after == 0;
    }
    previous_row_ = line.row;
    previous_col_ = line.col(line.pixels() - 1);
}

void UntimedScorer::add_token(int row, int col, EdgeTokenKind kind) {
    tokens_.push_back(
        {static_cast<std::int16_t>(row - window_.row), static_cast<std::int16_t>(col - window_.col), kind});
}

void UntimedScorer::build_edge_map() {
    constexpr std::size_t most_at_once = 32;
    if (!tokens_.empty()) {
        EdgeToken const* next = tokens_.data();
        EdgeToken const* const last = next + tokens_.size() - 1;
        while (next != last) {
            auto const count = std::min<std::size_t>(most_at_once, static_cast<std::size_t>(last - next));
            maps_->take(*next, next + 1, static_cast<unsigned>(count));
            next += count;
        }
        maps_->take_last(*last, edge_map_.flush_last);
    }
    maps_->finish();
}

/// Row by row: those of the image as they lie there, the others as no readings.
void UntimedScorer::sweep(SampleCounters& counters) const {
    static thread_local std::vector<std::uint16_t> depth;
    static thread_local std::vector<std::uint8_t> edges;
    auto const side = static_cast<std::size_t>(window_.side);
    depth.assign(side * side, 0);
    edges.assign(side * side, 0);
    Overlap const rows(window_.row, window_.side, stimulus_.height), cols(window_.col, window_.side, stimulus_.width);
    for (int row = rows.first; row < rows.end && cols.first < cols.end; ++row) {
        auto const image_row = static_cast<int>(window_.row + row), image_col = static_cast<int>(window_.col + cols.first);
        std::size_t const to = static_cast<std::size_t>(row) * side + static_cast<std::size_t>(cols.first);
        std::copy_n(stimulus_.observed_depth.row(image_row) + image_col, cols.end - cols.first, depth.data() + to);
        std::copy_n(stimulus_.observed_edges.row(image_row) + image_col, cols.end - cols.first, edges.data() + to);
    }
    sweep_.sweep(0, side * side, depth_buffer_.data(), maps_->edge(), depth.data(), edges.data(), counters);
}

}  // namespace faster::datapath
