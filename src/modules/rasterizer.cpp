#include "modules/rasterizer.hpp"

#include <algorithm>

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
      thresholds_(datapath::threshold_codes(core.config.edge_map.thresholds, core.stimulus.fraction.vertex_xy)) {
    SC_THREAD(run);
}

void Rasterizer::end_of_elaboration() {
    command_ = &channel_of(command_out);
    fragment_depth_ = &channel_of(fragment_depth_out);
    fragment_index_ = &channel_of(fragment_index_out);
    edge_token_ = channel_of(edge_token_out);
    clock_.connect_reads(channel_of(sample_raster_in));
    clock_.connect_reads(channel_of(vertex_in));
    clock_.connect_writes(channel_of(area_out));
    clock_.connect_writes(*command_);
    clock_.connect_writes(*fragment_depth_);
    clock_.connect_writes(*fragment_index_);
    std::vector<FifoChannel*> written{command_, fragment_depth_, fragment_index_};
    if (edge_token_ != nullptr) {
        clock_.connect_writes(*edge_token_);
        written.push_back(edge_token_);
    }
    scan_loop_ = clock_.add_loop(loop_shape(LoopId::scan, core_.config), written);
    clock_.set_setup_cycles(core_.config.setup_depth);
    edge_port_ = edge_token_ != nullptr ? edge_token_->write_port() : std::uint8_t{0};
    fragment_ports_ = static_cast<std::uint8_t>(command_->write_port() | fragment_depth_->write_port() |
                                                fragment_index_->write_port() | edge_port_);
}

void Rasterizer::run() {
    for (std::size_t i = 0; i < core_.sample_count; ++i) {
        core_.begin_sample(ModuleId::rasterizer);
        for (auto const& call : core_.sample_begins)
            call(i);
        start_sample();
        for (std::uint32_t left = core_.sample(i).triangle_count; left > 0; --left) {
            TriangleCode const triangle = receive_triangle();
            datapath::TriangleSetup const setup = datapath::set_up(
                triangle, core_.stimulus.width, core_.stimulus.height, core_.stimulus.fraction.vertex_xy);
            clock_.set_up();
            announce(setup);
            if (setup.drawn())
                draw(setup);
        }
        end_sample();
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

void Rasterizer::draw(datapath::TriangleSetup const& setup) {
    if (edge_token_ == nullptr)
        scan_fragments(setup);
    else
        sends_near_edges_ ? scan_near_edges(setup) : scan(setup);
}

void Rasterizer::scan(datapath::TriangleSetup const& setup) {
    previous_row_ = setup.start_row;
    previous_col_ = setup.start_col;
    previous_inside_ = setup.starts_inside();
    clock_.enter_loop(scan_loop_);
    begin_burst(setup);
    datapath::ZigzagScan zigzag(setup);
    while (!zigzag.done())
        send_line(zigzag.next_line());
    end_burst();
    clock_.leave_loop();
}

/// The iterations of one line: pixels outside are silent but for the first after the inside run, which is an edge.
void Rasterizer::send_line(datapath::ScanLine const& line) {
    int silent = line.before;
    if (previous_inside_ && silent > 0) {  // the run ended with the last line
        send_edge(line.row, line.first_col);
        previous_inside_ = false;
        --silent;
    }
    if (silent > 0)
        clock_.iterate(0, static_cast<std::uint64_t>(silent));
    if (line.before > 0) {
        previous_row_ = line.row;
        previous_col_ = line.col(line.before - 1);
    }
    if (line.inside > 0)
        send_run(line);
    else if (line.after > 0)
        clock_.iterate(0, static_cast<std::uint64_t>(line.after));
    previous_row_ = line.row;
    previous_col_ = line.col(line.pixels() - 1);
}

/// The run of covered pixels, and the edge behind it. Where the scan comes in from outside, the pixel before is an edge
/// as well; it is sent by an iteration of its own after the first covered pixel, unless the triangle ends there (as in
/// A.1, which then loses it).
void Rasterizer::send_run(datapath::ScanLine const& line) {
    auto const count = static_cast<std::uint32_t>(line.inside);
    bool const ends_here = line.last && line.inside == 1 && line.after == 0;
    bool const flushes = !previous_inside_ && !ends_here;
    bool const leaves = line.after > 0;
    send_tokens(line, flushes, leaves);
    previous_inside_ = !leaves;
    auto const silent = static_cast<std::uint32_t>(leaves ? line.after - 1 : 0);
    if (flushes && leaves && count > 1) {
        clock_.iterate_flanked(fragment_ports_, count, edge_port_, silent);
        return;
    }
    if (flushes)
        clock_.iterate_with_tail(fragment_ports_, 1, edge_port_, 0);
    std::uint32_t const rest = flushes ? count - 1 : count;
    if (leaves && rest > 0) {
        clock_.iterate_with_tail(fragment_ports_, rest, edge_port_, silent);
    } else if (leaves) {
        clock_.iterate(edge_port_, 1);
        clock_.iterate(0, silent);
    } else {
        clock_.iterate(fragment_ports_, rest);
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

void Rasterizer::send_edge(int row, int col) {
    *burst_.token++ = token_at(row, col, EdgeTokenKind::Edge);
    if (clock_.lockstep())
        hand_over();
    clock_.iterate(edge_port_, 1);
}

/// Without edges to look for: an iteration per pixel.
void Rasterizer::scan_fragments(datapath::TriangleSetup const& setup) {
    clock_.enter_loop(scan_loop_);
    begin_burst(setup);
    datapath::ZigzagScan zigzag(setup);
    while (!zigzag.done())
        send_fragments(zigzag.next_line());
    end_burst();
    clock_.leave_loop();
}

void Rasterizer::send_fragments(datapath::ScanLine const& line) {
    clock_.iterate(0, static_cast<std::uint64_t>(line.before));
    send_stretch(line, {line.before, line.before + line.inside, true, false});
    clock_.iterate(fragment_ports_, static_cast<std::uint64_t>(line.inside));
    clock_.iterate(0, static_cast<std::uint64_t>(line.after));
}

/// Thesis 5.1: every pixel of the box near an edge of the triangle is a token, covered or not.
void Rasterizer::scan_near_edges(datapath::TriangleSetup const& setup) {
    clock_.enter_loop(scan_loop_);
    begin_burst(setup);
    datapath::NearEdgeScan scan(setup, thresholds_);
    while (!scan.done())
        send_near_edge_line(scan.next_line());
    end_burst();
    clock_.leave_loop();
}

void Rasterizer::send_near_edge_line(datapath::NearEdgeLine const& line) {
    for (int pixel = 0; pixel < line.inside.pixels();) {
        datapath::Stretch const stretch = line.stretch_from(pixel);
        send_stretch(line.inside, stretch);
        unsigned const fragment_ports = stretch.is_inside ? unsigned{fragment_ports_} & ~unsigned{edge_port_} : 0U;
        unsigned const token_port = stretch.is_near ? edge_port_ : 0U;
        clock_.iterate(static_cast<std::uint8_t>(fragment_ports | token_port),
                       static_cast<std::uint64_t>(stretch.end - stretch.first));
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
    if (edge_token_ != nullptr)
        edge_token_->await_room();
    auto const pixels = static_cast<std::size_t>(setup.right_wall - setup.left_wall + 1) *
                        static_cast<std::size_t>(setup.bottom - setup.start_row + 1);
    burst_.command = command_->reserve(pixels);
    burst_.first_depth = burst_.depth = fragment_depth_->reserve(pixels);
    burst_.index = fragment_index_->reserve(pixels);
    burst_.first_token = burst_.token = edge_token_ != nullptr ? edge_token_->reserve(2 * pixels) : nullptr;
}

/// Makes what the scan has written part of the channels.
void Rasterizer::hand_over() {
    auto const fragments = static_cast<std::size_t>(burst_.depth - burst_.first_depth);
    burst_.command = std::fill_n(burst_.command, fragments, Command::Fragment);
    command_->append(fragments);
    fragment_depth_->append(fragments);
    fragment_index_->append(fragments);
    if (edge_token_ != nullptr)
        edge_token_->append(static_cast<std::size_t>(burst_.token - burst_.first_token));
    burst_.first_depth = burst_.depth;
    burst_.first_token = burst_.token;
}

void Rasterizer::end_burst() {
    hand_over();
    command_->wake_reader();
    fragment_depth_->wake_reader();
    fragment_index_->wake_reader();
    if (edge_token_ != nullptr)
        edge_token_->wake_reader();
}

void Rasterizer::end_sample() {
    clock_.advance(1);
    {
        Step const step(clock_);
        command_out.write(Command::End);
        if (edge_token_ != nullptr)
            edge_token_out->write({0, 0, EdgeTokenKind::End});
    }
    clock_.advance(1);
}

EdgeToken Rasterizer::token_at(int row, int col, EdgeTokenKind kind) const {
    return {static_cast<std::int16_t>(row - row_offset_), static_cast<std::int16_t>(col - col_offset_), kind};
}

}  // namespace faster
