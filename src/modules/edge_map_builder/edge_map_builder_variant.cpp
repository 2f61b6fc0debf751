#include "modules/edge_map_builder/edge_map_builder_variant.hpp"

#include <utility>

#include "faster/config/clear_design.hpp"
#include "modules/core/conditions.hpp"
#include "modules/core/described_parts.hpp"
#include "modules/core/read_corners.hpp"
#include "modules/core/token_widths.hpp"
#include "modules/edge_map_builder/edge_map_builder.hpp"
#include "modules/edge_map_builder/map_accesses.hpp"

namespace faster {

namespace {
bool ends_sample(PixelGroup const& group) { return group.mask == 0; }
}  // namespace

bool EdgeMapBuilderVariant::is_needed(AcceleratorConfig const& config) {
    return config.edge_map.algorithm != EdgeMapAlgorithm::dual_map || config.edge_map.clearing != MapClearing::loop ||
           has_map_buffers(config, true).holds || config.rasterizer.lanes > 1 || config.inlier_unit.sweep_lanes > 1 ||
           sweeps_touched_region(config).holds;
}

ModuleDescription EdgeMapBuilderVariant::describe(AcceleratorConfig const& config) {
    EdgeMapDesign const& design = design_of(config.edge_map.algorithm);
    Condition const two_buffers = has_map_buffers(config, true);
    ModuleDescription module = EdgeMapBuilder::describe(config.window);
    module.only_if(finds_edges_while_drawing(config));
    end_of(module, "edge_map") = EdgeMapReadOut::described_end(config).only_if(has_map_buffers(config, false));
    module.writes_to("map_full")
        .carries("finished maps from the edge map builder to the edge map output (edge_map.buffers 2)")
        .of_bits(wires::buffer + wires::region(config))
        .only_if(two_buffers);
    module.reads_from("map_free").only_if(two_buffers);
    touch_maps(loop_of(module, "clear"), design.clear);
    add_token_branches(loop_of(module, "token"), design, config.flow == Flow::faster ? config.rasterizer.lanes : 1);
    loop_of(module, "output") = EdgeMapReadOut::described_loop(config).only_if(has_map_buffers(config, false));
    for (auto const& [name, bits] :
         {std::pair{"edge_map", design.bits.edge_map}, std::pair{"object_map", design.bits.object_map}}) {
        MemoryDescription& memory = memory_of(module, name);
        memory.bits = bits;
        memory.in_buffers(static_cast<std::uint64_t>(config.edge_map.buffers)).read_out_by("edge_map_output");
    }
    return module;
}

EdgeMapBuilderVariant::EdgeMapBuilderVariant(sc_core::sc_module_name const& name, CoreContext const& core,
                                             EdgeMapBuffers& buffers)
    : CoreModule(name, core), buffers_(buffers), read_out_(clock_) {}

void EdgeMapBuilderVariant::connect() {
    edge_token_ = channel_of(edge_token_in.pixels);
    edge_groups_ = channel_of(edge_token_in.groups);
    map_free_ = channel_of(map_free_in);
    map_full_ = channel_of(map_full_out);
    token_.connect(clock_, "token", edge_token_);
    group_.connect(clock_, "token", edge_groups_);
    watched_.watch({clock_.write_distances("token", "edge_map"), clock_.write_distances("token", "object_map")});
    if (ClockedFifo<std::uint8_t>* const edge_map = channel_of(edge_map_out); edge_map != nullptr)
        read_out_.connect(*edge_map);
}

void EdgeMapBuilderVariant::start() { maps_ = buffers_.claim(buffer_).get(); }

void EdgeMapBuilderVariant::work(std::size_t i) {
    clock_.advance(1);
    clear();
    edge_token_ != nullptr ? build() : build_of_groups();
    maps_->finish();
    core_.show_edge_maps(i, {maps_->edge(), maps_->object(), maps_->side()});
    if (buffers_.size() > 1)
        hand_over();
    else
        read_out_.send(*maps_, core_.rows_of(turn_to_output()));
}

/// The finished maps, for those that have been read out meanwhile.
void EdgeMapBuilderVariant::hand_over() {
    Corners const region = core_.sweeps_touched() ? read_region() : corners_of(core_.whole_window());
    buffers_.release(buffer_);
    clock_.here();
    map_full_->write({BufferNumber(buffer_), region});
    clock_.advance(1);
    clock_.here();
    buffer_ = map_free_->read().number;
    clock_.advance(1);
    maps_ = buffers_.claim(buffer_).get();
}

void EdgeMapBuilderVariant::clear() {
    maps_->clear();
    clock_.pipeline("clear", edge_clear_iterations(core_.config, core_.stimulus.window));
}

/// As EdgeMapBuilder::build(), with any algorithm.
void EdgeMapBuilderVariant::build() {
    clock_.here();
    EdgeToken current = edge_token_->read();
    clock_.advance(1);
    if (current.kind == EdgeTokenKind::End) {
        clock_.advance(1);
        return;
    }
    token_.run_mixed([&](unsigned most, EdgeToken const* next) {
        return watched_.take(*maps_, current, next, most, core_.config.edge_map.flush_last);
    });
}

/// EdgeMapBuilder::build() with tokens of several pixels. inner_border alone has them, and no second iterations.
void EdgeMapBuilderVariant::build_of_groups() {
    clock_.here();
    PixelGroup current = edge_groups_->read();
    clock_.advance(1);
    if (ends_sample(current)) {
        clock_.advance(1);
        return;
    }
    group_.run_while([&](PixelGroup const& next) {
        watched_.take_group(*maps_, current);
        current = next;
        return !ends_sample(current);
    });
}

/// The pixels that leave.
PixelBox EdgeMapBuilderVariant::turn_to_output() {
    if (core_.sweeps_touched())
        return box_of(read_region());
    clock_.advance(1);
    return core_.whole_window();
}

Corners EdgeMapBuilderVariant::read_region() {
    return read_corners(clock_, [this] { return read_corner(); });
}

FragmentIndex EdgeMapBuilderVariant::read_corner() {
    if (edge_groups_ != nullptr) {
        PixelGroup const group = edge_groups_->read();
        return {group.row, group.col};
    }
    EdgeToken const token = edge_token_->read();
    return {token.row, token.col};
}

}  // namespace faster
