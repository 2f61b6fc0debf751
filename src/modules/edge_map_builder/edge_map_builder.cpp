#include "modules/edge_map_builder/edge_map_builder.hpp"

#include <algorithm>

#include "faster/config/clear_design.hpp"
#include "modules/core/conditions.hpp"
#include "modules/core/token_widths.hpp"
#include "modules/rasterizer/read_corners.hpp"

namespace faster {

namespace {
bool is_end(EdgeToken const& token) { return token.kind == EdgeTokenKind::End; }

/// A read takes a cycle, and what is written depends on it (docs/timing-model.md#hazards).
MemoryStages token_stages(char const* map, std::uint64_t reads, std::uint64_t writes) {
    return {map, 2, 3, reads, writes};
}
}  // namespace

ModuleDescription EdgeMapBuilder::describe(AcceleratorConfig const& config) {
    EdgeMapDesign const& design = design_of(config.edge_map.algorithm);
    Condition const two_buffers = has_map_buffers(config, true);
    auto const lanes = static_cast<std::uint64_t>(config.flow == Flow::faster ? config.rasterizer.lanes : 1);
    ModuleDescription module("edge_map_builder");
    module.only_if(finds_edges_while_drawing(config));
    module.reads_from("edge_token");
    EdgeMapReadOut::describe_output(module, config, has_map_buffers(config, false));
    module.writes_to("map_full")
        .carries("finished maps from the edge map builder to the edge map output (edge_map.buffers 2)")
        .of_bits(wires::buffer + wires::region(config))
        .only_if(two_buffers);
    module.reads_from("map_free").only_if(two_buffers);
    EdgeMapReadOut::touch(
        module.loop("clear").does("clears one pixel of both maps, or one of every bank, per iteration").of_depth(2),
        design.clear);
    EdgeMapReadOut::touch(module.loop("token")
                              .does("takes one edge token per iteration, or finishes the object token before it")
                              .of_depth(4)
                              .recurs_every(design.token_recurrence)
                              .in_stages(token_stages("edge_map", design.token_reads.edge_map * lanes,
                                                      design.token_writes.edge_map * lanes))
                              .in_stages(token_stages("object_map", design.token_reads.object_map * lanes,
                                                      design.token_writes.object_map * lanes)),
                          design.token, static_cast<int>(lanes));
    EdgeMapReadOut::describe_loop(module, config).only_if(has_map_buffers(config, false));
    auto const side = static_cast<std::uint64_t>(config.window);
    auto const add_map = [&](char const* name, char const* contents, std::uint64_t bits) {
        module.memory(name)
            .holds(contents)
            .of_words(side, side, bits)
            .sized_by("accelerator.window")
            .in_buffers(static_cast<std::uint64_t>(config.edge_map.buffers))
            .read_out_by("edge_map_output");
    };
    add_map("edge_map", "edge bits of the window", design.bits.edge_map);
    add_map("object_map", "object bits of the window", design.bits.object_map);
    return module;
}

EdgeMapBuilder::EdgeMapBuilder(sc_core::sc_module_name const& name, CoreContext const& core, EdgeMapBuffers& buffers)
    : sc_module(name), core_(core), clock_(core.core, "edge_map_builder"), buffers_(buffers), read_out_(core, clock_) {
    SC_THREAD(run);
}

void EdgeMapBuilder::end_of_elaboration() {
    clock_.connect_all();
    edge_token_ = channel_of(edge_token_in.pixels);
    edge_groups_ = channel_of(edge_token_in.groups);
    map_free_ = channel_of(map_free_in);
    map_full_ = channel_of(map_full_out);
    clear_loop_ = clock_.loop("clear");
    token_loop_ = clock_.loop("token");
    watch_ = {clock_.write_distances("token", "edge_map"), clock_.write_distances("token", "object_map")};
    waits_for_writes_ = clock_.has_interlocks(token_loop_);
    if (ClockedFifo<std::uint8_t>* const edge_map = channel_of(edge_map_out); edge_map != nullptr)
        read_out_.connect(*edge_map);
}

void EdgeMapBuilder::run() {
    maps_ = buffers_.claim(buffer_).get();
    for (std::size_t i = 0; i < core_.sample_count; ++i) {
        clock_.begin_sample();
        clock_.advance(1);
        clear();
        edge_token_ != nullptr ? build() : build_of_groups();
        maps_->finish();
        if (core_.probe != nullptr)
            core_.probe->edge_maps_done(core_.first_sample + i, {maps_->edge(), maps_->object(), maps_->side()});
        if (buffers_.size() > 1)
            hand_over();
        else
            read_out_.send(*maps_, core_.rows_of(turn_to_output()));
    }
}

/// The finished maps, for those that have been read out meanwhile.
void EdgeMapBuilder::hand_over() {
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

void EdgeMapBuilder::clear() {
    maps_->clear();
    std::size_t const iterations = edge_clear_iterations(core_.config, core_.stimulus.window);
    if (iterations == 0)
        return;
    clock_.enter_loop(clear_loop_);
    clock_.iterate(timing::no_ports, iterations);
    clock_.leave_loop();
}

void EdgeMapBuilder::build() {
    clock_.here();
    EdgeToken current = edge_token_->read();
    clock_.advance(1);
    if (current.kind == EdgeTokenKind::End) {
        clock_.advance(1);
        return;
    }
    clock_.enter_loop(token_loop_);
    watch_.enter();
    while (take_tokens(current)) {
    }
    clock_.leave_loop();
}

/// Works off the tokens at hand. Every iteration that consumes `current` reads the next token in its step, so that the
/// loop knows the end token one iteration early. True until it has been read.
bool EdgeMapBuilder::take_tokens(EdgeToken& current) {
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
void EdgeMapBuilder::take_some(EdgeToken& current, EdgeToken const* next, unsigned count) {
    std::uint32_t const seconds = is_watched() ? take_watched(current, next, count) : maps_->take(current, next, count);
    current = next[count - 1];
    if (waits_for_writes_)
        tell_one(seconds != 0);
    else
        clock_.iterate_mixed(edge_token_->read_port(), count, seconds);
}

/// An iteration, and a second one, each of which may wait for what others write.
void EdgeMapBuilder::tell_one(bool second) {
    clock_.await_writes(token_loop_, second);
    clock_.iterate(edge_token_->read_port(), 1);
    if (!second)
        return;
    clock_.await_writes(token_loop_);
    clock_.iterate(timing::no_ports, 1);
}

/// Takes tokens one by one and notes what each iteration accesses; returns which of them have a second iteration.
std::uint32_t EdgeMapBuilder::take_watched(EdgeToken const& current, EdgeToken const* next, unsigned count) {
    std::uint32_t seconds = 0;
    for (unsigned i = 0; i < count; ++i) {
        watch_.next_iteration();
        seconds |= std::uint32_t{maps_->take_watched(i == 0 ? current : next[i - 1], watch_)} << i;
    }
    return seconds;
}

/// The last token before the end: its second iteration only runs if the configuration says so.
void EdgeMapBuilder::take_last(EdgeToken const& current) {
    watch_.next_iteration();
    bool const second = maps_->take_last_watched(current, core_.config.edge_map.flush_last, watch_);
    if (waits_for_writes_)
        tell_one(second);
    else
        clock_.iterate(edge_token_->read_port(), 1, second ? 1 : 0);
}

/// The pixels that leave.
PixelBox EdgeMapBuilder::turn_to_output() {
    if (core_.sweeps_touched())
        return box_of(read_region());
    clock_.advance(1);
    return core_.whole_window();
}

Corners EdgeMapBuilder::read_region() {
    return read_corners(clock_, [this] { return read_corner(); });
}

FragmentIndex EdgeMapBuilder::read_corner() {
    if (edge_groups_ != nullptr) {
        PixelGroup const group = edge_groups_->read();
        return {group.row, group.col};
    }
    EdgeToken const token = edge_token_->read();
    return {token.row, token.col};
}

}  // namespace faster
