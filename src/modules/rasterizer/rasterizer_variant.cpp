#include "modules/rasterizer/rasterizer_variant.hpp"

#include <algorithm>

#include "faster/config/sweep_design.hpp"
#include "modules/core/conditions.hpp"
#include "modules/core/described_parts.hpp"
#include "modules/core/token_widths.hpp"
#include "modules/rasterizer/rasterizer.hpp"
#include "modules/rasterizer/rasterizer_scan.hpp"

namespace faster {

namespace {
/// What `scan: spans` adds to a triangle's setup: 18 quotient bits, a bit per cycle, of the two divisions per edge
/// (where it crosses the first row, how far that moves from row to row), all six side by side.
constexpr Cycles span_division_cycles = 18;
/// What a column adds to a group's z sum, which is its first column's: signed, an extent of the triangle times one of
/// its depths. The first column need not be covered: modulo 2^48 its z sum is enough for those that are.
constexpr unsigned column_step_bits = wires::vertex_xy + wires::vertex_z + 1;

void describe_groups(ModuleDescription& module, AcceleratorConfig const& config) {
    unsigned const pixels = wires::pixel + wires::mask(config);
    end_of(module, "fragment_depth").bits += column_step_bits;
    end_of(module, "fragment_index").of_bits(pixels);
    end_of(module, "edge_token").of_bits(pixels);  // an empty mask is the end
}

/// The loop reads vertices and sends areas, too. A triangle is announced once the scan has come to it.
void describe_overlap(ModuleDescription& module) {
    LoopDescription& scan = loop_of(module, "scan");
    scan.writes_to({"command", "fragment_depth", "fragment_index", "edge_token", "area"});
    scan.also_reads({"vertex"});
    module.setup->activity = "waiting for triangles to be set up";
    module.setup->one_per_token_of.clear();
}
}  // namespace

bool RasterizerVariant::is_needed(AcceleratorConfig const& config) {
    RasterizerConfig const& own = config.rasterizer;
    return own.scan != ScanPolicy::zigzag || own.setup_overlap > 0 || own.edge_tokens != EdgeTokens::all ||
           own.lanes > 1 || config.edge_map.algorithm == EdgeMapAlgorithm::threshold ||
           !finds_edges_while_drawing(config).holds || sweeps_touched_region(config).holds;
}

ModuleDescription RasterizerVariant::describe(AcceleratorConfig const& config) {
    ModuleDescription module = Rasterizer::describe();
    end_of(module, "edge_token").only_if(finds_edges_while_drawing(config));
    module.writes_to("region")
        .carries(
            "two corners of the touched region from the rasterizer to the observation reader (sweep_region: touched)")
        .of_bits(wires::corner(config))
        .only_if(sweeps_touched_region(config));
    if (config.rasterizer.lanes > 1)
        describe_groups(module, config);
    if (config.rasterizer.setup_overlap > 0)
        describe_overlap(module);
    if (config.rasterizer.scan == ScanPolicy::spans)
        module.setup->extra = span_division_cycles;
    return module;
}

RasterizerVariant::RasterizerVariant(sc_core::sc_module_name const& name, CoreContext const& core)
    : CoreModule(name, core),
      sends_near_edges_(core.config.edge_map.algorithm == EdgeMapAlgorithm::threshold),
      thresholds_(datapath::threshold_codes(core.config.edge_map.thresholds, core.stimulus.fraction.vertex_xy)),
      scan_(core.config.rasterizer.setup_overlap > 0 ? configured_scan<true>() : configured_scan<false>()) {
    if (core.sweeps_touched())
        touched_.emplace(core.stimulus.window, touched_margin(core.config));
}

void RasterizerVariant::connect() {
    vertex_ = &channel_of(vertex_in);
    area_ = &channel_of(area_out);
    command_ = &channel_of(command_out);
    fragment_index_ = channel_of(fragment_index_out.pixels);
    edge_token_ = channel_of(edge_token_out.pixels);
    depth_groups_ = channel_of(fragment_depth_out.groups);
    index_groups_ = channel_of(fragment_index_out.groups);
    edge_groups_ = channel_of(edge_token_out.groups);
    FifoChannel* const edges = edge_token_out.channel();
    ports_.edge = edges != nullptr ? edges->write_port() : timing::Ports();
    pixel_ports_ = command_->write_port() | fragment_depth_out.channel()->write_port() |
                   fragment_index_out.channel()->write_port();
    ports_.fragment = pixel_ports_ | ports_.edge;
    if (fragment_index_ != nullptr)
        burst_.connect(*command_, *channel_of(fragment_depth_out.pixels), *fragment_index_, edge_token_);
    scan_loop_ = clock_.loop("scan");
}

void RasterizerVariant::work(std::size_t i) {
    start_sample();
    std::uint32_t const triangles = core_.sample(i).triangle_count;
    core_.config.rasterizer.setup_overlap > 0 ? draw_overlapped(triangles) : draw_one_by_one(triangles);
    end_sample();
}

void RasterizerVariant::draw_one_by_one(std::uint32_t triangles) {
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

void RasterizerVariant::start_sample() {
    clock_.here();
    SampleHeader const header = sample_raster_in.read();
    clock_.stamp();
    clock_.advance(1);
    window_ = WindowPlace::of(core_, header);
}

/// As Rasterizer::receive_triangle(), kept apart so that the thesis's page stays whole.
TriangleCode RasterizerVariant::receive_triangle() {
    TriangleCode triangle;
    for (VertexCode& vertex : triangle.vertex) {
        clock_.here();
        vertex = vertex_in.read();
        clock_.advance(1);
    }
    return triangle;
}

void RasterizerVariant::announce(datapath::TriangleSetup const& setup) {
    {
        Step const step(clock_);
        area_out.write(setup.area);
        if (setup.drawn())
            command_out.write(Command::Triangle);
    }
    clock_.advance(1);
}

datapath::TriangleSetup RasterizerVariant::set_up(TriangleCode const& triangle) const {
    return datapath::set_up(triangle, core_.stimulus.width, core_.stimulus.height, core_.stimulus.fraction.vertex_xy);
}

void RasterizerVariant::hand_over() {
    if (touched_)
        touch_written();
    burst_.hand_over();
}

void RasterizerVariant::end_burst() {
    hand_over();
    burst_.end();
}

void RasterizerVariant::end_sample() {
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

/// What the scan is about to hand over. A.1's edge tokens lie beside fragments, and count as their margin.
void RasterizerVariant::touch_written() {
    burst_.for_each_fragment([this](FragmentIndex const& pixel) { touched_->add(pixel.row, pixel.col); });
    if (sends_near_edges_)
        burst_.for_each_token([this](EdgeToken const& token) { touched_->add(token.row, token.col); });
}

void RasterizerVariant::send_region() {
    Corners const corners = corners_of(touched_->box());
    touched_->clear();
    send_corner(corners.first);
    send_corner(corners.last);
}

/// To all that go over the region.
void RasterizerVariant::send_corner(FragmentIndex const& corner) {
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

}  // namespace faster
