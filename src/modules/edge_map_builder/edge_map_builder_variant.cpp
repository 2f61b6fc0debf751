#include "modules/edge_map_builder/edge_map_builder_variant.hpp"

#include <algorithm>
#include <utility>

#include "faster/config/clear_design.hpp"
#include "modules/core/conditions.hpp"
#include "modules/core/described_parts.hpp"
#include "modules/core/token_widths.hpp"
#include "modules/edge_map_builder/edge_map_builder.hpp"
#include "modules/edge_map_builder/map_accesses.hpp"
#include "modules/rasterizer/read_corners.hpp"

namespace faster {

namespace {
bool is_end(EdgeToken const& token) { return token.kind == EdgeTokenKind::End; }
}  // namespace

bool EdgeMapBuilderVariant::is_needed(AcceleratorConfig const& config, Machine const& machine) {
    std::size_t const token_loop = machine.loop(machine.process("edge_map_builder"), "token");
    return config.edge_map.algorithm != EdgeMapAlgorithm::dual_map || config.edge_map.clearing != MapClearing::loop ||
           has_map_buffers(config, true).holds || config.rasterizer.lanes > 1 || config.inlier_unit.sweep_lanes > 1 ||
           sweeps_touched_region(config).holds || machine.loops[token_loop].has_interlocks();
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
    : sc_module(name), core_(core), clock_(core.core, "edge_map_builder"), buffers_(buffers), read_out_(core, clock_) {
    SC_THREAD(run);
}

void EdgeMapBuilderVariant::end_of_elaboration() {
    clock_.connect_all();
    edge_token_ = channel_of(edge_token_in.pixels);
    edge_groups_ = channel_of(edge_token_in.groups);
    map_free_ = channel_of(map_free_in);
    map_full_ = channel_of(map_full_out);
    clear_loop_ = clock_.loop("clear");
    token_loop_ = clock_.loop("token");
    watch_ = {clock_.write_distances("token", "edge_map"), clock_.write_distances("token", "object_map")};
    watched_.watch(watch_);
    waits_for_writes_ = clock_.has_interlocks(token_loop_);
    if (ClockedFifo<std::uint8_t>* const edge_map = channel_of(edge_map_out); edge_map != nullptr)
        read_out_.connect(*edge_map);
}

void EdgeMapBuilderVariant::run() {
    maps_ = buffers_.claim(buffer_).get();
    for (std::size_t i = 0; i < core_.sample_count; ++i) {
        clock_.begin_sample();
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
    std::size_t const iterations = edge_clear_iterations(core_.config, core_.stimulus.window);
    if (iterations == 0)
        return;
    clock_.enter_loop(clear_loop_);
    clock_.iterate(timing::no_ports, iterations);
    clock_.leave_loop();
}

void EdgeMapBuilderVariant::build() {
    clock_.here();
    EdgeToken current = edge_token_->read();
    clock_.advance(1);
    if (current.kind == EdgeTokenKind::End) {
        clock_.advance(1);
        return;
    }
    clock_.enter_loop(token_loop_);
    watched_.enter();
    while (take_tokens(current)) {
    }
    clock_.leave_loop();
}

/// Works off the tokens at hand. Every iteration that consumes `current` reads the next token in its step, so that the
/// loop knows the end token one iteration early. True until it has been read.
bool EdgeMapBuilderVariant::take_tokens(EdgeToken& current) {
    std::size_t const available = edge_token_->peek();
    EdgeToken const* const next = edge_token_->front();
    std::size_t const end = static_cast<std::size_t>(std::find_if(next, next + available, is_end) - next);
    std::size_t taken = 0;
    std::size_t const most_at_once = waits_for_writes_ ? 1 : timing::Operation::longest_mix;
    while (taken < end) {
        auto const count = static_cast<unsigned>(std::min(end - taken, most_at_once));
        take_some(current, next + taken, count);
        taken += count;
    }
    if (end < available) {
        take_last(current);
        taken += 1;
    }
    edge_token_->consume(taken);
    return end == available;
}

/// The iterations of `current` and of all but the last of `next`, told to the clock together: a bit each that says
/// whether a second one followed.
void EdgeMapBuilderVariant::take_some(EdgeToken& current, EdgeToken const* next, unsigned count) {
    std::uint32_t const seconds = watched_.take(*maps_, current, next, count);
    current = next[count - 1];
    if (waits_for_writes_)
        tell_one(seconds != 0);
    else
        clock_.iterate_mixed(edge_token_->read_port(), count, seconds);
}

/// An iteration, and a second one, each of which may wait for what others write.
void EdgeMapBuilderVariant::tell_one(bool second) {
    clock_.await_writes(token_loop_, second);
    clock_.iterate(edge_token_->read_port(), 1);
    if (!second)
        return;
    clock_.await_writes(token_loop_);
    clock_.iterate(timing::no_ports, 1);
}

/// The last token before the end: its second iteration only runs if the configuration says so.
void EdgeMapBuilderVariant::take_last(EdgeToken const& current) {
    bool const second = watched_.take_last(*maps_, current, core_.config.edge_map.flush_last);
    if (waits_for_writes_)
        tell_one(second);
    else
        clock_.iterate(edge_token_->read_port(), 1, second ? 1 : 0);
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
