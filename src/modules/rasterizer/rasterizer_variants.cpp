#include <algorithm>

#include "modules/rasterizer/rasterizer_scan.hpp"

namespace faster {

/// Thesis 5.1: every pixel of the box near an edge of the triangle is a token, covered or not.
template <bool Ahead> void RasterizerVariant::scan_near_edges(datapath::TriangleSetup const& setup) {
    burst_.begin(setup);
    datapath::NearEdgeScan scan(setup, thresholds_);
    while (!scan.done())
        send_near_edge_line<Ahead>(scan.next_line());
    end_burst();
}

template <bool Ahead> void RasterizerVariant::send_near_edge_line(datapath::NearEdgeLine const& line) {
    for (int pixel = 0; pixel < line.inside.pixels();) {
        datapath::Stretch const stretch = line.stretch_from(pixel);
        send_stretch(line.inside, stretch);
        timing::Ports const fragment_ports = stretch.is_inside ? pixel_ports_ : timing::Ports();
        timing::Ports const token_port = stretch.is_near ? ports_.edge : timing::Ports();
        iterate<Ahead>(fragment_ports | token_port, static_cast<std::uint32_t>(stretch.end - stretch.first));
        pixel = stretch.end;
    }
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
        write_run(line, nullptr, false);
    else
        send_stretch(line, {line.before, line.before + line.inside, true, false});
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
    area_->await_room();
    *area_->reserve(1) = setup.area;
    area_->commit(1);
    timing::Ports ports = area_->write_port();
    if (setup.drawn()) {
        command_->await_room();
        *command_->reserve(1) = Command::Triangle;
        command_->commit(1);
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
