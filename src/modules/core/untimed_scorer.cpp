#include "modules/core/untimed_scorer.hpp"

#include <algorithm>

#include "faster/data/fixed_point.hpp"
#include "modules/edge_map_builder/algorithms/dual_map.hpp"
#include "modules/edge_map_builder/algorithms/inner_border.hpp"

namespace faster::datapath {

namespace {

ContourDepth contour_depth(EdgeMapAlgorithm algorithm) {
    return contour_is_on_object(algorithm) ? ContourDepth::own : ContourDepth::neighbour;
}

}  // namespace

UntimedScorer::UntimedScorer(Stimulus const& stimulus, EdgeMapConfig const& edge_map, HiddenPixels hidden)
    : stimulus_(stimulus),
      edge_map_(edge_map),
      depth_unit_(stimulus.fraction),
      sweep_(stimulus.window, stimulus.fraction.depth_buffer, contour_depth(edge_map.algorithm)),
      valid_depths_(stimulus.observed_depth, stimulus.fraction.depth_buffer),
      maps_(make_edge_map_policy(edge_map.algorithm, stimulus.window)),
      depth_buffer_(static_cast<std::size_t>(stimulus.window) * static_cast<std::size_t>(stimulus.window),
                    far_depth_code),
      depth_row_(static_cast<std::size_t>(stimulus.window)),
      edge_row_(static_cast<std::size_t>(stimulus.window)) {
    window_.side = stimulus.window;
    if (hidden == HiddenPixels::counted)
        hidden_sweep_.emplace(stimulus.window, stimulus.fraction.depth_buffer);
}

SampleCounters UntimedScorer::score(Pose const& pose, SampleInput const& input) {
    window_.row = stimulus_.near_window_offset(input.centre_row);
    window_.col = stimulus_.near_window_offset(input.centre_col);
    maps_->clear();
    clear_drawn_rows();
    has_token_ = false;
    first_drawn_row_ = window_.side;
    end_drawn_row_ = 0;
    vertices_.clear();
    for (Eigen::Vector3d const& point : stimulus_.posed.mesh.vertices)
        vertices_.push_back(project(point, pose, stimulus_.posed.camera, stimulus_.fraction));
    SampleCounters counters;
    if (edge_map_.algorithm == EdgeMapAlgorithm::dual_map)
        draw_mesh_in_any_order(static_cast<DualMap&>(*maps_), counters);
    else if (edge_map_.algorithm == EdgeMapAlgorithm::inner_border)
        draw_mesh_in_any_order(static_cast<InnerBorder&>(*maps_), counters);
    else
        draw_mesh(*maps_, counters);
    sweep(counters);
    return counters;
}

/// What the sample before has drawn.
void UntimedScorer::clear_drawn_rows() {
    auto const row = [this](int number) { return depth_buffer_.begin() + std::ptrdiff_t{number} * window_.side; };
    int const first = std::max(0, first_drawn_row_), end = std::min(window_.side, end_drawn_row_);
    if (first < end)
        std::fill(row(first), row(end), far_depth_code);
}

TriangleSetup UntimedScorer::set_up_face(std::size_t face) const {
    auto const& corners = stimulus_.posed.mesh.faces[face];
    ProjectedVertex const& a = vertices_[corners[0]];
    ProjectedVertex const& b = vertices_[corners[1]];
    ProjectedVertex const& c = vertices_[corners[2]];
    if (!(a.usable && b.usable && c.usable))
        return {};
    return set_up({{a.code, b.code, c.code}}, stimulus_.width, stimulus_.height, stimulus_.fraction.vertex_xy);
}

/// The fragments of a line that lie in the window; how many of them were drawn. From pixel to pixel the product of z
/// sum and reciprocal changes by the same amount, modulo 2^64 if need be.
inline std::uint64_t UntimedScorer::draw_run(ScanLine const& line, std::uint64_t reciprocal) {
    std::int64_t const row = line.row - window_.row;
    if (row < 0 || row >= window_.side)
        return 0;
    int const ends[2]{line.col(line.before), line.col(line.before + line.inside - 1)};
    int const left = std::min(ends[0], ends[1]), right = std::max(ends[0], ends[1]);
    int const first = std::max(left, static_cast<int>(window_.col));
    int const end = std::min(right + 1, static_cast<int>(window_.col) + window_.side);
    std::int64_t const per_column = line.step * line.z_sum_per_step;
    std::uint16_t* word = depth_buffer_.data() + row * window_.side - window_.col + first;
    std::int64_t z_sum = line.z_sum + (first - ends[0]) * per_column;
    std::uint64_t drawn = 0;
    if (!depth_unit_.adds_up()) {
        for (int col = first; col < end; ++col, z_sum += per_column)
            drawn +=
                depth_unit_.draw(depth_unit_.fragment_depth(static_cast<std::uint64_t>(z_sum), reciprocal), *word++);
        return drawn;
    }
    DepthUnit const unit = depth_unit_;  // the compiler cannot know that drawing leaves it alone
    std::uint64_t product = static_cast<std::uint64_t>(z_sum) * reciprocal;
    std::uint64_t const step = static_cast<std::uint64_t>(per_column) * reciprocal;
    for (int col = first; col < end; ++col, product += step)
        drawn += unit.draw(product >> unit.shift(), *word++) ? 1U : 0U;
    return drawn;
}

template <class Maps> void UntimedScorer::draw_mesh(Maps& maps, SampleCounters& counters) {
    for (std::size_t face = 0; face < stimulus_.posed.mesh.faces.size(); ++face)
        if (TriangleSetup const setup = set_up_face(face); setup.drawn())
            draw(setup, maps, counters);
    if (has_token_)
        maps.take_last(token_, edge_map_.flush_last);
    maps.finish();
}

template <class Maps> void UntimedScorer::draw_mesh_in_any_order(Maps& maps, SampleCounters& counters) {
    std::size_t const last = last_face_with_tokens();
    for (std::size_t face = 0; face < stimulus_.posed.mesh.faces.size(); ++face)
        if (TriangleSetup const setup = set_up_face(face); face != last && setup.drawn())
            draw_in_any_order(setup, maps, counters);
    if (last < stimulus_.posed.mesh.faces.size()) {
        draw(set_up_face(last), maps, counters);
        maps.take_last(token_, edge_map_.flush_last);
    }
    maps.finish();
}

/// The last triangle that covers a pixel; the number of all if none does.
std::size_t UntimedScorer::last_face_with_tokens() const {
    for (std::size_t face = stimulus_.posed.mesh.faces.size(); face-- > 0;) {
        TriangleSetup const setup = set_up_face(face);
        if (!setup.drawn())
            continue;
        ZigzagScan lines(setup);
        while (!lines.done())
            if (lines.next_line().inside > 0)
                return face;
    }
    return stimulus_.posed.mesh.faces.size();
}

/// Whether the window has all pixels of the triangle's box.
bool UntimedScorer::holds(TriangleSetup const& setup) const {
    return depth_unit_.adds_up() && setup.start_row >= window_.row && setup.bottom < window_.row + window_.side &&
           setup.left_wall >= window_.col && setup.right_wall < window_.col + window_.side;
}

void UntimedScorer::begin(TriangleSetup const& setup) {
    int const top = setup.start_row - static_cast<int>(window_.row);
    first_drawn_row_ = std::min(first_drawn_row_, top - 1);  // the contour lies one row beside
    end_drawn_row_ = std::max(end_drawn_row_, setup.bottom - static_cast<int>(window_.row) + 2);
    previous_inside_ = setup.starts_inside();
    previous_row_ = top;
    previous_col_ = setup.start_col - static_cast<int>(window_.col);
}

template <class Maps> void UntimedScorer::draw(TriangleSetup const& setup, Maps& maps, SampleCounters& counters) {
    std::uint64_t const reciprocal = reciprocal_of(setup.area, stimulus_.fraction);
    begin(setup);
    ZigzagScan lines(setup);
    while (!lines.done()) {
        ScanLine const line = lines.next_line();
        if (line.inside > 0)
            counters.valid_raster += draw_run(line, reciprocal);
        add_tokens(line, maps);
    }
}

/// Triangles are small, and where their lines begin and end is hard to foretell: what add_tokens() asks step by step
/// is asked without branches here. The whole box lies in the window, so nothing is compared with its sides.
template <class Maps>
void UntimedScorer::draw_in_any_order(TriangleSetup const& setup, Maps& maps, SampleCounters& counters) {
    if (!holds(setup))
        return draw(setup, maps, counters);
    std::uint64_t const reciprocal = reciprocal_of(setup.area, stimulus_.fraction);
    begin(setup);
    TokenMarks const marks = maps.marks();
    std::uint8_t unread = 0;
    auto const mark_edge_if = [&marks, &unread](bool is_sent, std::ptrdiff_t at) {
        *(is_sent ? marks.edge + at : &unread) = 1;
    };
    DepthUnit const unit = depth_unit_;  // the compiler cannot know that marking leaves it alone
    std::ptrdiff_t const side = window_.side;
    ZigzagScan lines(setup);
    std::uint64_t const step = static_cast<std::uint64_t>(lines.z_per_column()) * reciprocal;
    bool was_inside = setup.starts_inside();
    std::ptrdiff_t line = previous_row_ * side + setup.left_wall - window_.col;  ///< its pixel at the left wall
    std::ptrdiff_t before = line + setup.start_col - setup.left_wall;
    std::uint64_t drawn = 0;
    while (!lines.done()) {
        bool const is_last = lines.is_last();
        CoveredRun const run = lines.next_run();
        bool const covers = run.covers(), rightwards = run.rightwards();
        std::int64_t const near = rightwards ? run.first - 1 : run.last + 1;
        std::int64_t const far = rightwards ? run.last + 1 : run.first - 1;
        bool const comes_in = !covers | (rightwards ? run.first > run.begin : run.last < run.begin);
        bool const goes_out = rightwards ? run.last < run.end : run.first > run.end;
        bool const ends_here = is_last & (run.first == run.last) & !goes_out;
        mark_edge_if(was_inside & comes_in, line + run.begin);
        mark_edge_if(covers & (comes_in | !was_inside) & !ends_here, comes_in ? line + near : before);
        mark_edge_if(covers & goes_out, line + far);
        std::uint64_t product =
            static_cast<std::uint64_t>(run.z_sum) * reciprocal + static_cast<std::uint64_t>(run.first) * step;
        std::uint16_t* const words = depth_buffer_.data() + line;
        for (std::int64_t col = run.first; col <= run.last; ++col, product += step) {
            drawn += unit.draw(product >> unit.shift(), words[col]) ? 1U : 0U;
            marks.object[line + col] = 1;
        }
        was_inside = covers & !goes_out;
        before = line + run.end;
        line += side;
    }
    counters.valid_raster += drawn;
}

/// Covered pixels are objects; the pixel behind a run is an edge, and so is the one before it, which is sent after the
/// run's first pixel unless the triangle ends there (A.1 loses it then).
template <class Maps> void UntimedScorer::add_tokens(ScanLine const& line, Maps& maps) {
    int const row = line.row - static_cast<int>(window_.row), first = line.first_col - static_cast<int>(window_.col);
    auto const col = [&](int pixel) { return first + pixel * line.step; };
    if (previous_inside_ && line.before > 0) {
        add_token(row, first, EdgeTokenKind::Edge, maps);
        previous_inside_ = false;
    }
    if (line.before > 0) {
        previous_row_ = row;
        previous_col_ = col(line.before - 1);
    }
    if (line.inside > 0) {
        bool const ends_here = line.last && line.inside == 1 && line.after == 0;
        add_token(row, col(line.before), EdgeTokenKind::Object, maps);
        if (!previous_inside_ && !ends_here)
            add_token(previous_row_, previous_col_, EdgeTokenKind::Edge, maps);
        if (line.inside > 1)
            add_run(row, col(line.before + 1), col(line.before + line.inside - 1), line.step, maps);
        if (line.after > 0)
            add_token(row, col(line.before + line.inside), EdgeTokenKind::Edge, maps);
        previous_inside_ = line.after == 0;
    }
    previous_row_ = row;
    previous_col_ = col(line.pixels() - 1);
}

/// The last token of a sample is another's business: each is kept back until there is a next one.
template <class Maps> void UntimedScorer::add_token(int row, int col, EdgeTokenKind kind, Maps& maps) {
    if (has_token_)
        maps.take(token_, nullptr, 1);
    token_ = {static_cast<std::int16_t>(row), static_cast<std::int16_t>(col), kind};
    has_token_ = true;
}

/// There is a token before: that of the run's first pixel.
template <class Maps> void UntimedScorer::add_run(int row, int first_col, int last_col, int step, Maps& maps) {
    maps.take(token_, nullptr, 1);
    if (step > 0)
        maps.take_run(row, first_col, last_col, true);
    else
        maps.take_run(row, last_col + 1, first_col + 1, false);
    token_ = {static_cast<std::int16_t>(row), static_cast<std::int16_t>(last_col), EdgeTokenKind::Object};
}

/// Rows in which nothing is drawn only count valid depths, which a table knows, as long as "far" lies beyond what is
/// compared.
void UntimedScorer::sweep(SampleCounters& counters) {
    constexpr int most_bits_with_far = 9;
    bool const everywhere = stimulus_.fraction.depth_buffer > most_bits_with_far;
    int const first = everywhere ? 0 : std::max(0, first_drawn_row_);
    int const end = everywhere ? window_.side : std::min(window_.side, end_drawn_row_);
    for (int row = first; row < end; ++row)
        sweep_row(row, counters);
    counters.valid_depth = valid_depths_.count(window_.row, window_.col, window_.side);
}

/// What lies outside the image has no readings.
void UntimedScorer::sweep_row(int row, SampleCounters& counters) {
    auto const side = static_cast<std::size_t>(window_.side);
    std::int64_t const image_row = window_.row + row;
    std::uint16_t const* depth = depth_row_.data();
    std::uint8_t const* edges = edge_row_.data();
    if (image_row >= 0 && image_row < stimulus_.height && window_.col >= 0 &&
        window_.col + window_.side <= stimulus_.width) {
        depth = stimulus_.observed_depth.row(static_cast<int>(image_row)) + window_.col;
        edges = stimulus_.observed_edges.row(static_cast<int>(image_row)) + window_.col;
    } else {
        for (std::size_t i = 0; i < side; ++i) {
            std::int64_t const col = window_.col + static_cast<std::int64_t>(i);
            bool const inside = image_row >= 0 && image_row < stimulus_.height && col >= 0 && col < stimulus_.width;
            auto const at = std::pair(static_cast<int>(image_row), static_cast<int>(col));
            depth_row_[i] = inside ? stimulus_.observed_depth.at(at.first, at.second) : std::uint16_t{0};
            edge_row_[i] = inside ? stimulus_.observed_edges.at(at.first, at.second) : std::uint8_t{0};
        }
    }
    std::size_t const from = static_cast<std::size_t>(row) * side;
    sweep_.sweep(from, side, depth_buffer_.data(), maps_->edge() + from, depth, edges, counters);
    if (hidden_sweep_)
        hidden_sweep_->sweep(from, side, depth_buffer_.data(), depth, counters);
}

}  // namespace faster::datapath
