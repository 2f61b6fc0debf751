#include "modules/rasterizer/rasterizer.hpp"

#include <algorithm>

#include "faster/config/sweep_design.hpp"
#include "modules/core/conditions.hpp"
#include "modules/core/token_widths.hpp"
#include "modules/rasterizer/rasterizer_scan.hpp"

namespace faster {

namespace {
/// What `scan: spans` adds to a triangle's setup: 18 quotient bits, a bit per cycle, of the two divisions per edge
/// (where it crosses the first row, how far that moves from row to row), all six side by side.
constexpr Cycles span_division_cycles = 18;
/// Of a z sum: weights of a point inside add up to the area. Groups have their first column's, which modulo 2^48 is
/// enough for the covered ones, and what a column adds: signed, an extent of the triangle times one of its depths.
constexpr unsigned z_sum_bits = wires::magnitude_of_area + wires::vertex_z;
constexpr unsigned column_step_bits = wires::vertex_xy + wires::vertex_z + 1;

/// Token coordinates have 16 bits. No image is wider than 4096 pixels, so a window further off covers none of it either
/// way.
int clamped_offset(std::int64_t offset) { return static_cast<int>(std::clamp<std::int64_t>(offset, -8192, 8192)); }
}  // namespace

ModuleDescription Rasterizer::describe(AcceleratorConfig const& config) {
    bool const in_groups = config.rasterizer.lanes > 1;
    bool const overlaps = config.rasterizer.setup_overlap > 0;
    ModuleDescription module("rasterizer");
    module.reads_from("sample_raster");
    module.reads_from("vertex");
    module.writes_to("area")
        .carries("triangle areas from the rasterizer to the reciprocal unit")
        .of_bits(wires::magnitude_of_area + 1);  // signed
    module.writes_to("command").carries("commands from the rasterizer to the inlier unit").of_bits(2).leaves("scan", 7);
    module.writes_to("fragment_depth")
        .carries("z sums of fragments from the rasterizer to the inlier unit")
        .of_bits(z_sum_bits + (in_groups ? column_step_bits : 0))
        .leaves("scan", 7);
    module.writes_to("fragment_index")
        .carries("pixels of fragments from the rasterizer to the inlier unit")
        .of_bits(wires::pixel + wires::mask(config))
        .leaves("scan", 7);
    module.writes_to("edge_token")
        .carries("object and edge pixels from the rasterizer to the edge map builder")
        .of_bits(wires::pixel + (in_groups ? wires::mask(config) : 2))  // an empty mask is the end; edge, object or end
        .leaves("scan", 7)
        .only_if(finds_edges_while_drawing(config));
    module.writes_to("region")
        .carries(
            "two corners of the touched region from the rasterizer to the observation reader (sweep_region: touched)")
        .of_bits(wires::corner(config))
        .only_if(sweeps_touched_region(config));
    std::vector<std::string> written{"command", "fragment_depth", "fragment_index", "edge_token"};
    if (overlaps)
        written.emplace_back("area");
    module.loop("scan")
        .does("visits one pixel or group per iteration, or sends a pending edge token")
        .of_depth(8)
        .writes_to(written)
        .also_reads(overlaps ? std::vector<std::string>{"vertex"} : std::vector<std::string>{});
    module.setup = SetupDescription{12,
                                    config.rasterizer.scan == ScanPolicy::spans ? span_division_cycles : 0,
                                    "Cycles of the triangle setup, from the third vertex to the area.",
                                    overlaps ? "waiting for triangles to be set up" : "setting up triangles",
                                    "scan",
                                    overlaps ? "" : "area"};
    return module;
}

Rasterizer::Rasterizer(sc_core::sc_module_name const& name, CoreContext const& core)
    : sc_module(name),
      core_(core),
      clock_(core.core, "rasterizer"),
      sends_near_edges_(core.config.edge_map.algorithm == EdgeMapAlgorithm::threshold),
      thresholds_(datapath::threshold_codes(core.config.edge_map.thresholds, core.stimulus.fraction.vertex_xy)),
      scan_(core.config.rasterizer.setup_overlap > 0 ? configured_scan<true>() : configured_scan<false>()) {
    if (core.sweeps_touched())
        touched_.emplace(core.stimulus.window, touched_margin(core.config));
    SC_THREAD(run);
}

void Rasterizer::end_of_elaboration() {
    clock_.connect_all();
    vertex_ = &channel_of(vertex_in);
    area_ = &channel_of(area_out);
    command_ = &channel_of(command_out);
    fragment_depth_ = channel_of(fragment_depth_out.pixels);
    fragment_index_ = channel_of(fragment_index_out.pixels);
    edge_token_ = channel_of(edge_token_out.pixels);
    depth_groups_ = channel_of(fragment_depth_out.groups);
    index_groups_ = channel_of(fragment_index_out.groups);
    edge_groups_ = channel_of(edge_token_out.groups);
    FifoChannel* const edges = edge_token_out.channel();
    edge_port_ = edges != nullptr ? edges->write_port() : timing::Ports();
    pixel_ports_ = command_->write_port() | fragment_depth_out.channel()->write_port() |
                   fragment_index_out.channel()->write_port();
    fragment_ports_ = pixel_ports_ | edge_port_;
    scan_loop_ = clock_.loop("scan");
}

void Rasterizer::run() {
    for (std::size_t i = 0; i < core_.sample_count; ++i) {
        clock_.begin_sample();
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
    if (touched_)
        touch(fragments);
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
            edge_token_->write({0, 0, EdgeTokenKind::End});
        if (edge_groups_ != nullptr)
            edge_groups_->write({0, 0, 0});
    }
    clock_.advance(1);
    if (touched_)
        send_region();
}

/// What the scan has written since it last handed over. A.1's edge tokens lie beside fragments, and count as their
/// margin.
void Rasterizer::touch(std::size_t fragments) {
    for (FragmentIndex const* index = burst_.index - fragments; index != burst_.index; ++index)
        touched_->add(index->row, index->col);
    if (sends_near_edges_)
        for (EdgeToken const* token = burst_.first_token; token != burst_.token; ++token)
            touched_->add(token->row, token->col);
}

void Rasterizer::send_region() {
    Corners const corners = corners_of(touched_->box());
    touched_->clear();
    send_corner(corners.first);
    send_corner(corners.last);
}

/// To all that go over the region.
void Rasterizer::send_corner(FragmentIndex const& corner) {
    {
        Step const step(clock_);
        PixelGroup const group{corner.row, corner.col, 0};
        index_groups_ != nullptr ? index_groups_->write(group) : fragment_index_->write(corner);
        if (edge_token_ != nullptr)
            edge_token_->write({corner.row, corner.col, EdgeTokenKind::End});
        if (edge_groups_ != nullptr)
            edge_groups_->write(group);
        region_out->write(corner);
    }
    clock_.advance(1);
}

EdgeToken Rasterizer::token_at(int row, int col, EdgeTokenKind kind) const {
    return {static_cast<std::int16_t>(row - row_offset_), static_cast<std::int16_t>(col - col_offset_), kind};
}

/// Flattened: all that it calls, down to the clock's log, in one piece is worth 6 % of a run.
template __attribute__((flatten)) void Rasterizer::scan<datapath::ZigzagScan, false>(
    datapath::TriangleSetup const& setup);

}  // namespace faster
