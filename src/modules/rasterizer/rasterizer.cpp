#include "modules/rasterizer/rasterizer.hpp"

#include "channels/port_binding.hpp"
#include "modules/core/token_widths.hpp"

namespace faster {

ModuleDescription Rasterizer::describe() {
    constexpr unsigned z_sum_bits = wires::magnitude_of_area + wires::vertex_z;  // weights inside add up to the area
    ModuleDescription module("rasterizer");
    module.reads_from("sample_raster");
    module.reads_from("vertex");
    module.writes_to("area")
        .carries("triangle areas from the rasterizer to the reciprocal unit")
        .of_bits(wires::magnitude_of_area + 1);  // signed
    module.writes_to("command").carries("commands from the rasterizer to the inlier unit").of_bits(2).leaves("scan", 7);
    module.writes_to("fragment_depth")
        .carries("z sums of fragments from the rasterizer to the inlier unit")
        .of_bits(z_sum_bits)
        .leaves("scan", 7);
    module.writes_to("fragment_index")
        .carries("pixels of fragments from the rasterizer to the inlier unit")
        .of_bits(wires::pixel)
        .leaves("scan", 7);
    module.writes_to("edge_token")
        .carries("object and edge pixels from the rasterizer to the edge map builder")
        .of_bits(wires::pixel + 2)  // edge, object or end
        .leaves("scan", 7);
    module.loop("scan").does("visits one pixel or group per iteration, or sends a pending edge token").of_depth(8);
    SetupDescription& setup = module.setup.emplace();
    setup.depth = 12;
    setup.meaning = "Cycles of the triangle setup, from the third vertex to the area.";
    setup.activity = "setting up triangles";
    setup.before_loop = "scan";
    setup.one_per_token_of = "area";
    return module;
}

void Rasterizer::connect() {
    scan_loop_ = clock_.loop("scan");
    burst_.connect(channel_of(command_out), channel_of(fragment_depth_out), channel_of(fragment_index_out),
                   &channel_of(edge_token_out));
    ports_.edge = channel_of(edge_token_out).write_port();
    ports_.fragment = channel_of(command_out).write_port() | channel_of(fragment_depth_out).write_port() |
                      channel_of(fragment_index_out).write_port() | ports_.edge;
}

void Rasterizer::work(std::size_t i) {
    clock_.here();
    window_ = WindowPlace::of(core_, sample_raster_in.read());
    clock_.stamp();
    clock_.advance(1);
    for (std::uint32_t triangles = core_.sample(i).triangle_count; triangles > 0; --triangles)
        draw(receive_triangle());
    end_sample();
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

void Rasterizer::draw(TriangleCode const& triangle) {
    datapath::TriangleSetup const setup =
        datapath::set_up(triangle, core_.stimulus.width, core_.stimulus.height, core_.stimulus.fraction.vertex_xy);
    clock_.set_up();
    {
        Step const step(clock_);
        area_out.write(setup.area);
        if (setup.drawn())
            command_out.write(Command::Triangle);
    }
    clock_.advance(1);
    if (setup.drawn())
        scan(setup);
}

/// Flattened: all that it calls, down to the clock's log, in one piece is worth 6 % of a run.
__attribute__((flatten)) void Rasterizer::scan(datapath::TriangleSetup const& setup) {
    clock_.enter_loop(scan_loop_);
    previous_ = window_.token(setup.start_row, setup.start_col, EdgeTokenKind::Edge);
    previous_inside_ = setup.starts_inside();
    burst_.begin(setup);
    for (datapath::ZigzagScan lines(setup); !lines.done();)
        scan_line(lines.next_line());
    burst_.end();
    clock_.leave_loop();
}

/// The iterations of one line: pixels outside are silent but for the first behind a covered one, which is an edge.
inline void Rasterizer::scan_line(datapath::ScanLine const& line) {
    auto silent = static_cast<std::uint32_t>(line.before);
    if (previous_inside_ && silent > 0) {  // the run ended with the last line
        burst_.write_edge(window_.token(line.row, line.first_col, EdgeTokenKind::Edge));
        burst_.hand_over_if(clock_.lockstep());
        clock_.iterate(ports_.edge, 1);
        previous_inside_ = false;
        --silent;
    }
    if (silent > 0)
        clock_.iterate(timing::no_ports, silent);
    if (line.before > 0)
        previous_ = window_.token(line.row, line.col(line.before - 1), EdgeTokenKind::Edge);
    if (line.inside > 0)
        scan_run(line);
    else if (line.after > 0)
        clock_.iterate(timing::no_ports, static_cast<std::uint32_t>(line.after));
    previous_ = window_.token(line.row, line.col(line.pixels() - 1), EdgeTokenKind::Edge);
}

/// The run of covered pixels, and the edge behind it. Where the scan comes in from outside, the pixel before is an edge
/// as well; it is sent by an iteration of its own after the first covered pixel, unless the triangle ends there (as in
/// A.1, which then loses it).
inline void Rasterizer::scan_run(datapath::ScanLine const& line) {
    bool const ends_here = line.last && line.inside == 1 && line.after == 0;
    bool const flushes = !previous_inside_ && !ends_here;
    bool const leaves = line.after > 0;
    burst_.write_run(line, window_, flushes ? &previous_ : nullptr, leaves);
    burst_.hand_over_if(clock_.lockstep());
    previous_inside_ = !leaves;
    tell_run(clock_, ports_, {line.inside, flushes, leaves, leaves ? line.after - 1 : 0});
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

}  // namespace faster
