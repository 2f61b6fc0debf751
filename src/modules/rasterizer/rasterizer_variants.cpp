#include <algorithm>

#include "modules/rasterizer/rasterizer_scan.hpp"

namespace faster {

/// Thesis 5.1: every pixel of the box near an edge of the triangle is a token, covered or not. Flattened, so that lines
/// stay in registers.
template <bool Ahead> [[gnu::flatten]] void RasterizerVariant::scan_near_edges(datapath::TriangleSetup const& setup) {
    burst_.begin(setup);
    datapath::NearEdgeScan scan(setup, thresholds_);
    while (!scan.done())
        send_near_edge_line<Ahead>(scan.next_line());
    end_burst();
}

template <bool Ahead> void RasterizerVariant::send_near_edge_line(datapath::NearEdgeLine const& line) {
    burst_.write_fragments(line.covered, window_);
    burst_.write_edges(line.covered, window_, line.near_first, line.far_first);
    burst_.write_edges(line.covered, window_, line.far_end, line.near_end);
    hand_over_in_lockstep();
    auto const iterations = [this](timing::Ports ports, int count) {
        if (count > 0)
            iterate<Ahead>(ports, static_cast<std::uint32_t>(count));
    };
    timing::Ports const both = pixel_ports_ | ports_.edge;
    iterations(timing::no_ports, line.near_first);
    iterations(ports_.edge, line.covered_first - line.near_first);
    iterations(both, line.far_first - line.covered_first);
    iterations(pixel_ports_, line.far_end - line.far_first);
    iterations(both, line.covered_end - line.far_end);
    iterations(ports_.edge, line.near_end - line.covered_end);
    iterations(timing::no_ports, line.covered.pixels() - line.near_end);
}

/// Without tokens of what lies beside a triangle: no iteration but those of the pixels.
template <class Lines, bool Ahead> void RasterizerVariant::scan_covered(datapath::TriangleSetup const& setup) {
    burst_.begin(setup);
    Lines lines(setup);
    while (!lines.done())
        send_covered<Lines, Ahead>(lines.next_line());
    end_burst();
}

template <class Lines, bool Ahead> void RasterizerVariant::send_covered(datapath::ScanLine const& line) {
    if (line.inside == 0) {
        iterate<Ahead>(timing::no_ports, static_cast<std::uint32_t>(Lines::skips_outside ? 1 : line.pixels()));
        return;
    }
    if (!Lines::skips_outside)
        iterate<Ahead>(timing::no_ports, static_cast<std::uint32_t>(line.before));
    if (edge_token_ != nullptr)
        burst_.write_run(line, window_, nullptr, false);
    else
        burst_.write_fragments(line, window_);
    hand_over_in_lockstep();
    iterate<Ahead>(ports_.fragment, static_cast<std::uint32_t>(line.inside));
    if (!Lines::skips_outside)
        iterate<Ahead>(timing::no_ports, static_cast<std::uint32_t>(line.after));
}

template <class Lines, bool Ahead> RasterizerVariant::Scan RasterizerVariant::scan_along() const {
    bool const only_covered =
        core_.config.flow == Flow::fpga_grip || core_.config.rasterizer.edge_tokens == EdgeTokens::object;
    if (core_.config.rasterizer.lanes > 1)
        return &RasterizerVariant::scan_groups<Lines, Ahead>;
    return only_covered ? &RasterizerVariant::scan_covered<Lines, Ahead> : &RasterizerVariant::scan<Lines, Ahead>;
}

template <bool Ahead> RasterizerVariant::Scan RasterizerVariant::configured_scan() const {
    if (sends_near_edges_)
        return &RasterizerVariant::scan_near_edges<Ahead>;
    switch (core_.config.rasterizer.scan) {
        case ScanPolicy::early_exit:
            return scan_along<datapath::EarlyExitScan, Ahead>();
        case ScanPolicy::spans:
            return scan_along<datapath::SpanScan, Ahead>();
        case ScanPolicy::zigzag:
            break;
    }
    return scan_along<datapath::ZigzagScan, Ahead>();
}

/// One loop for the sample. Its first iterations read the vertices of the first triangles; then the first three of each
/// triangle read those of another.
void RasterizerVariant::draw_overlapped(std::uint32_t triangles) {
    if (triangles == 0)
        return;
    ahead_.unread = triangles;
    clock_.enter_loop(scan_loop_);
    for (std::uint64_t i = std::min<std::uint64_t>(core_.config.rasterizer.setup_overlap, triangles); i > 0; --i) {
        read_ahead();
        iterate<true>(timing::no_ports, 3);
    }
    for (; triangles > 0; --triangles) {
        datapath::TriangleSetup const setup = ahead_.setups.front();
        ahead_.setups.pop_front();
        begin_triangle(setup);
        if (setup.drawn())
            (this->*scan_)(setup);
        iterate<true>(timing::no_ports, ahead_.first_iterations);
    }
    clock_.leave_loop();
}

/// An iteration of its own sends the area and, if drawn, the command, as soon as the triangle is set up.
void RasterizerVariant::begin_triangle(datapath::TriangleSetup const& setup) {
    clock_.await_setup();
    read_ahead();
    area_->put(setup.area);
    timing::Ports ports = area_->write_port();
    if (setup.drawn()) {
        command_->put(Command::Triangle);
        ports = ports | command_->write_port();
    }
    iterate<true>(ports, 1);
}

/// The next three iterations are a triangle's first, and read the vertices of another, if there is one left.
void RasterizerVariant::read_ahead() {
    ahead_.first_iterations = 3;
    ahead_.reads = ahead_.unread > 0;
    ahead_.unread -= ahead_.reads ? 1U : 0U;
}

void RasterizerVariant::first_iteration(timing::Ports ports) {
    --ahead_.first_iterations;
    if (!ahead_.reads) {
        clock_.iterate(ports, 1);
        return;
    }
    fetch_vertex();
    clock_.iterate(ports | vertex_->read_port(), 1);
    vertex_->consume(1);
    if (ahead_.first_iterations == 0) {
        clock_.begin_setup();
        ahead_.setups.push_back(set_up(ahead_.triangle));
    }
}

void RasterizerVariant::fetch_vertex() {
    vertex_->peek();
    ahead_.triangle.vertex[2 - ahead_.first_iterations] = *vertex_->front();
}

template RasterizerVariant::Scan RasterizerVariant::configured_scan<false>() const;
template RasterizerVariant::Scan RasterizerVariant::configured_scan<true>() const;

}  // namespace faster
