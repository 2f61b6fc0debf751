#include "modules/rasterizer.hpp"

#include <algorithm>

#include "channels/port_binding.hpp"
#include "config/rasterizer_design.hpp"
#include "datapath/early_exit_scan.hpp"
#include "datapath/span_scan.hpp"
#include "modules/core_shapes.hpp"

namespace faster {

namespace {
/// Token coordinates have 16 bits. No image is wider than 4096 pixels, so a window further off covers none of it either
/// way.
int clamped_offset(std::int64_t offset) { return static_cast<int>(std::clamp<std::int64_t>(offset, -8192, 8192)); }
}  // namespace

Rasterizer::Rasterizer(sc_core::sc_module_name const& name, CoreContext const& core)
    : sc_module(name),
      core_(core),
      clock_(core.timing, basename(), core.time_base),
      sends_near_edges_(core.config.edge_map.algorithm == EdgeMapAlgorithm::threshold),
      thresholds_(datapath::threshold_codes(core.config.edge_map.thresholds, core.stimulus.fraction.vertex_xy)),
      scan_(core.config.rasterizer.setup_overlap > 0 ? configured_scan<true>() : configured_scan<false>()) {
    SC_THREAD(run);
}

void Rasterizer::end_of_elaboration() {
    vertex_ = &channel_of(vertex_in);
    area_ = &channel_of(area_out);
    command_ = &channel_of(command_out);
    fragment_depth_ = &channel_of(fragment_depth_out);
    fragment_index_ = &channel_of(fragment_index_out);
    edge_token_ = &channel_of(edge_token_out);
    clock_.connect_reads(channel_of(sample_raster_in));
    clock_.connect_reads(*vertex_);
    clock_.connect_writes(*area_);
    clock_.connect_writes(*command_);
    clock_.connect_writes(*fragment_depth_);
    clock_.connect_writes(*fragment_index_);
    clock_.connect_writes(*edge_token_);
    std::vector<FifoChannel*> written{command_, fragment_depth_, fragment_index_, edge_token_};
    std::vector<FifoChannel*> read_as_well;
    if (core_.config.rasterizer.setup_overlap > 0) {
        written.push_back(area_);
        read_as_well.push_back(vertex_);
    }
    scan_loop_ = clock_.add_loop(loop_shape(LoopId::scan, core_.config), written, read_as_well);
    clock_.set_setup_cycles(setup_cycles(core_.config));
    edge_port_ = edge_token_->write_port();
    fragment_ports_ = static_cast<std::uint8_t>(command_->write_port() | fragment_depth_->write_port() |
                                                fragment_index_->write_port() | edge_port_);
}

void Rasterizer::run() {
    for (std::size_t i = 0; i < core_.sample_count; ++i) {
        core_.begin_sample(ModuleId::rasterizer);
        for (auto const& call : core_.sample_begins)
            call(i);
        start_sample();
        std::uint32_t const triangles = core_.sample(i).triangle_count;
        core_.config.rasterizer.setup_overlap > 0 ? draw_overlapped(triangles) : draw_one_by_one(triangles);
        end_sample();
    }
}

void Rasterizer::draw_one_by_one(std::uint32_t triangles) {
    for (; triangles > 0; --triangles) {
        datapath::TriangleSetup const setup = set_up(receive_triangle());
        clock_.set_up();
        announce(setup);
        if (!setup.drawn())
            continue;
        clock_.enter_loop(scan_loop_);
        (this->*scan_)(setup);
        clock_.leave_loop();
    }
}

/// One loop for the sample. Its first iterations read the vertices of the first triangles; then the first three of each
/// triangle read those of another.
void Rasterizer::draw_overlapped(std::uint32_t triangles) {
    if (triangles == 0)
        return;
    ahead_.unread = triangles;
    clock_.enter_loop(scan_loop_);
    for (std::uint64_t i = std::min<std::uint64_t>(core_.config.rasterizer.setup_overlap, triangles); i > 0; --i) {
        read_ahead();
        iterate<true>(0, 3);
    }
    for (; triangles > 0; --triangles) {
        datapath::TriangleSetup const setup = ahead_.setups.front();
        ahead_.setups.pop_front();
        begin_triangle(setup);
        if (setup.drawn())
            (this->*scan_)(setup);
        iterate<true>(0, ahead_.first_iterations);
    }
    clock_.leave_loop();
}

/// An iteration of its own sends the area and, if drawn, the command, as soon as the triangle is set up.
void Rasterizer::begin_triangle(datapath::TriangleSetup const& setup) {
    clock_.await_setup();
    read_ahead();
    area_->await_room();
    *area_->reserve(1) = setup.area;
    area_->commit(1);
    unsigned ports = area_->write_port();
    if (setup.drawn()) {
        command_->await_room();
        *command_->reserve(1) = Command::Triangle;
        command_->commit(1);
        ports |= command_->write_port();
    }
    iterate<true>(static_cast<std::uint8_t>(ports), 1);
}

/// The next three iterations are a triangle's first, and read the vertices of another, if there is one left.
void Rasterizer::read_ahead() {
    ahead_.first_iterations = 3;
    ahead_.reads = ahead_.unread > 0;
    ahead_.unread -= ahead_.reads ? 1U : 0U;
}

void Rasterizer::first_iteration(std::uint8_t ports) {
    --ahead_.first_iterations;
    if (!ahead_.reads) {
        clock_.iterate(ports, 1);
        return;
    }
    fetch_vertex();
    clock_.iterate(static_cast<std::uint8_t>(ports | vertex_->read_port()), 1);
    vertex_->consume(1);
    if (ahead_.first_iterations == 0) {
        clock_.begin_setup();
        ahead_.setups.push_back(set_up(ahead_.triangle));
    }
}

void Rasterizer::fetch_vertex() {
    vertex_->peek();
    ahead_.triangle.vertex[2 - ahead_.first_iterations] = *vertex_->front();
}

/// Iterations of the scan. Those that a triangle begins with may have something else to do beside it.
template <bool Ahead> void Rasterizer::iterate(std::uint8_t ports, std::uint32_t count) {
    if constexpr (Ahead)
        for (; ahead_.first_iterations > 0 && count > 0; --count)
            first_iteration(ports);
    clock_.iterate(ports, count);
}

template <bool Ahead>
void Rasterizer::iterate_with_tail(std::uint8_t ports, std::uint32_t count, std::uint8_t tail_ports,
                                   std::uint32_t tail_gap) {
    if (Ahead && ahead_.first_iterations > 0) {
        iterate<Ahead>(ports, count);
        iterate<Ahead>(tail_ports, 1);
        iterate<Ahead>(0, tail_gap);
    } else {
        clock_.iterate_with_tail(ports, count, tail_ports, tail_gap);
    }
}

template <bool Ahead>
void Rasterizer::iterate_flanked(std::uint8_t ports, std::uint32_t count, std::uint8_t tail_ports,
                                 std::uint32_t tail_gap) {
    if (Ahead && ahead_.first_iterations > 0) {
        iterate_with_tail<Ahead>(ports, 1, tail_ports, 0);
        iterate_with_tail<Ahead>(ports, count - 1, tail_ports, tail_gap);
    } else {
        clock_.iterate_flanked(ports, count, tail_ports, tail_gap);
    }
}

void Rasterizer::start_sample() {
    clock_.here();
    SampleHeader const header = sample_raster_in.read();
    clock_.stamp();
    clock_.advance(1);
    row_offset_ = clamped_offset(core_.window_offset(header.centre_row));
    col_offset_ = clamped_offset(core_.window_offset(header.centre_col));
}

TriangleCode Rasterizer::receive_triangle() {
    TriangleCode triangle;
    for (VertexCode& vertex : triangle.vertex) {
        clock_.here();
        vertex = vertex_in.read();
        clock_.advance(1);
    }
    return triangle;
}

void Rasterizer::announce(datapath::TriangleSetup const& setup) {
    {
        Step const step(clock_);
        area_out.write(setup.area);
        if (setup.drawn())
            command_out.write(Command::Triangle);
    }
    clock_.advance(1);
}

datapath::TriangleSetup Rasterizer::set_up(TriangleCode const& triangle) const {
    return datapath::set_up(triangle, core_.stimulus.width, core_.stimulus.height, core_.stimulus.fraction.vertex_xy);
}

template <bool Ahead> Rasterizer::Scan Rasterizer::configured_scan() const {
    if (sends_near_edges_)
        return &Rasterizer::scan_near_edges<Ahead>;
    switch (core_.config.rasterizer.scan) {
        case ScanPolicy::early_exit:
            return &Rasterizer::scan<datapath::EarlyExitScan, Ahead>;
        case ScanPolicy::spans:
            return &Rasterizer::scan<datapath::SpanScan, Ahead>;
        case ScanPolicy::zigzag:
            break;
    }
    return &Rasterizer::scan<datapath::ZigzagScan, Ahead>;
}

template <class Lines, bool Ahead> void Rasterizer::scan(datapath::TriangleSetup const& setup) {
    previous_row_ = setup.start_row;
    previous_col_ = setup.start_col;
    previous_inside_ = setup.starts_inside();
    begin_burst(setup);
    Lines lines(setup);
    while (!lines.done())
        send_line<Lines, Ahead>(lines.next_line());
    end_burst();
}

/// The iterations of one line: pixels outside are silent but for the first after the inside run, which is an edge.
template <class Lines, bool Ahead> void Rasterizer::send_line(datapath::ScanLine const& line) {
    int silent = line.before;
    if (previous_inside_ && silent > 0) {  // the run ended with the last line
        send_edge<Ahead>(line.row, line.first_col);
        previous_inside_ = false;
        silent = Lines::skips_outside ? 0 : silent - 1;
    }
    if (Lines::skips_outside)
        silent = silent > 0 && line.inside == 0 ? 1 : 0;
    if (silent > 0)
        iterate<Ahead>(0, static_cast<std::uint32_t>(silent));
    if (line.before > 0) {
        previous_row_ = line.row;
        previous_col_ = line.col(line.before - 1);
    }
    if (line.inside > 0)
        send_run<Lines, Ahead>(line);
    else if (line.after > 0)
        iterate<Ahead>(0, static_cast<std::uint32_t>(line.after));
    previous_row_ = line.row;
    previous_col_ = line.col(line.pixels() - 1);
}

/// The run of covered pixels, and the edge behind it. Where the scan comes in from outside, the pixel before is an edge
/// as well; it is sent by an iteration of its own after the first covered pixel, unless the triangle ends there (as in
/// A.1, which then loses it).
template <class Lines, bool Ahead> void Rasterizer::send_run(datapath::ScanLine const& line) {
    auto const count = static_cast<std::uint32_t>(line.inside);
    bool const ends_here = line.last && line.inside == 1 && line.after == 0;
    bool const flushes = !previous_inside_ && !ends_here;
    bool const leaves = line.after > 0;
    send_tokens(line, flushes, leaves);
    previous_inside_ = !leaves;
    auto const silent = static_cast<std::uint32_t>(leaves && !Lines::skips_outside ? line.after - 1 : 0);
    if (flushes && leaves && count > 1) {
        iterate_flanked<Ahead>(fragment_ports_, count, edge_port_, silent);
        return;
    }
    if (flushes)
        iterate_with_tail<Ahead>(fragment_ports_, 1, edge_port_, 0);
    std::uint32_t const rest = flushes ? count - 1 : count;
    if (leaves && rest > 0) {
        iterate_with_tail<Ahead>(fragment_ports_, rest, edge_port_, silent);
    } else if (leaves) {
        iterate<Ahead>(edge_port_, 1);
        iterate<Ahead>(0, silent);
    } else {
        iterate<Ahead>(fragment_ports_, rest);
    }
}

void Rasterizer::send_tokens(datapath::ScanLine const& line, bool flushes, bool leaves) {
    std::int64_t* depth = burst_.depth;
    FragmentIndex* index = burst_.index;
    EdgeToken* token = burst_.token;
    std::int64_t z_sum = line.z_sum;
    auto const row = static_cast<std::int16_t>(line.row - row_offset_);
    int col = line.col(line.before) - col_offset_;
    int const end = col + line.inside * line.step;
    auto const send = [&] {
        *depth++ = z_sum;
        *index++ = {row, static_cast<std::int16_t>(col)};
        *token++ = {row, static_cast<std::int16_t>(col), EdgeTokenKind::Object};
        z_sum += line.z_sum_per_step;
        col += line.step;
    };
    send();
    if (flushes)
        *token++ = token_at(previous_row_, previous_col_, EdgeTokenKind::Edge);
    while (col != end)
        send();
    if (leaves)
        *token++ = {row, static_cast<std::int16_t>(col), EdgeTokenKind::Edge};
    burst_.depth = depth;
    burst_.index = index;
    burst_.token = token;
    if (clock_.lockstep())
        hand_over();
}

template <bool Ahead> void Rasterizer::send_edge(int row, int col) {
    *burst_.token++ = token_at(row, col, EdgeTokenKind::Edge);
    if (clock_.lockstep())
        hand_over();
    iterate<Ahead>(edge_port_, 1);
}

/// Thesis 5.1: every pixel of the box near an edge of the triangle is a token, covered or not.
template <bool Ahead> void Rasterizer::scan_near_edges(datapath::TriangleSetup const& setup) {
    begin_burst(setup);
    datapath::NearEdgeScan scan(setup, thresholds_);
    while (!scan.done())
        send_near_edge_line<Ahead>(scan.next_line());
    end_burst();
}

template <bool Ahead> void Rasterizer::send_near_edge_line(datapath::NearEdgeLine const& line) {
    for (int pixel = 0; pixel < line.inside.pixels();) {
        datapath::Stretch const stretch = line.stretch_from(pixel);
        send_stretch(line.inside, stretch);
        unsigned const fragment_ports = stretch.is_inside ? unsigned{fragment_ports_} & ~unsigned{edge_port_} : 0U;
        unsigned const token_port = stretch.is_near ? edge_port_ : 0U;
        iterate<Ahead>(static_cast<std::uint8_t>(fragment_ports | token_port),
                       static_cast<std::uint32_t>(stretch.end - stretch.first));
        pixel = stretch.end;
    }
}

void Rasterizer::send_stretch(datapath::ScanLine const& line, datapath::Stretch const& stretch) {
    for (int pixel = stretch.first; pixel < stretch.end; ++pixel) {
        EdgeToken const token = token_at(line.row, line.col(pixel), EdgeTokenKind::Edge);
        if (stretch.is_inside) {
            *burst_.depth++ = line.z_sum + (pixel - line.before) * line.z_sum_per_step;
            *burst_.index++ = {token.row, token.col};
        }
        if (stretch.is_near)
            *burst_.token++ = token;
    }
    if (clock_.lockstep())
        hand_over();
}

/// Room for all that a scan may send: a fragment and an edge for every pixel of the box.
void Rasterizer::begin_burst(datapath::TriangleSetup const& setup) {
    command_->await_room();
    fragment_depth_->await_room();
    fragment_index_->await_room();
    edge_token_->await_room();
    auto const pixels = static_cast<std::size_t>(setup.right_wall - setup.left_wall + 1) *
                        static_cast<std::size_t>(setup.bottom - setup.start_row + 1);
    burst_.command = command_->reserve(pixels);
    burst_.first_depth = burst_.depth = fragment_depth_->reserve(pixels);
    burst_.index = fragment_index_->reserve(pixels);
    burst_.first_token = burst_.token = edge_token_->reserve(2 * pixels);
}

/// Makes what the scan has written part of the channels.
void Rasterizer::hand_over() {
    auto const fragments = static_cast<std::size_t>(burst_.depth - burst_.first_depth);
    burst_.command = std::fill_n(burst_.command, fragments, Command::Fragment);
    command_->append(fragments);
    fragment_depth_->append(fragments);
    fragment_index_->append(fragments);
    edge_token_->append(static_cast<std::size_t>(burst_.token - burst_.first_token));
    burst_.first_depth = burst_.depth;
    burst_.first_token = burst_.token;
}

void Rasterizer::end_burst() {
    hand_over();
    command_->wake_reader();
    fragment_depth_->wake_reader();
    fragment_index_->wake_reader();
    edge_token_->wake_reader();
}

void Rasterizer::end_sample() {
    clock_.advance(1);
    {
        Step const step(clock_);
        command_out.write(Command::End);
        edge_token_out.write({0, 0, EdgeTokenKind::End});
    }
    clock_.advance(1);
}

EdgeToken Rasterizer::token_at(int row, int col, EdgeTokenKind kind) const {
    return {static_cast<std::int16_t>(row - row_offset_), static_cast<std::int16_t>(col - col_offset_), kind};
}

}  // namespace faster
