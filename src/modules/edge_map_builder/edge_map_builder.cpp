#include "modules/edge_map_builder/edge_map_builder.hpp"

#include <algorithm>

#include "channels/port_binding.hpp"
#include "modules/edge_map_builder/map_accesses.hpp"

namespace faster {

ModuleDescription EdgeMapBuilder::describe(int window) {
    EdgeMapDesign const& design = design_of(EdgeMapAlgorithm::dual_map);
    ModuleDescription module("edge_map_builder");
    module.reads_from("edge_token");
    module.writes_to("edge_map")
        .carries("edge bits from the edge map builder to the inlier unit")
        .of_bits(1)
        .leaves("output", 2);
    touch_maps(
        module.loop("clear").does("clears one pixel of both maps, or one of every bank, per iteration").of_depth(2),
        design.clear);
    add_token_branches(module.loop("token")
                           .does("takes one edge token per iteration, or finishes the object token before it")
                           .of_depth(4),
                       design);
    touch_maps(module.loop("output").does("sends one token of edge bits per iteration").of_depth(3), design.output);
    auto const side = static_cast<std::uint64_t>(window);
    auto const keep = [&](char const* name, char const* contents, std::uint64_t bits) {
        module.memory(name).holds(contents).of_words(side, side, bits).sized_by("accelerator.window");
    };
    keep("edge_map", "edge bits of the window", design.bits.edge_map);
    keep("object_map", "object bits of the window", design.bits.object_map);
    return module;
}

EdgeMapBuilder::EdgeMapBuilder(sc_core::sc_module_name const& name, CoreContext const& core)
    : sc_module(name), core_(core), clock_(core.core, "edge_map_builder"), maps_(core.stimulus.window) {
    SC_THREAD(run);
}

void EdgeMapBuilder::end_of_elaboration() {
    clock_.connect_all();
    edge_token_ = &channel_of(edge_token_in);
    edge_map_ = &channel_of(edge_map_out);
    clear_loop_ = clock_.loop("clear");
    token_loop_ = clock_.loop("token");
    output_loop_ = clock_.loop("output");
    watched_.watch({clock_.write_distances("token", "edge_map"), clock_.write_distances("token", "object_map")});
}

void EdgeMapBuilder::run() {
    for (std::size_t i = 0; i < core_.sample_count; ++i) {
        clock_.begin_sample();
        clock_.advance(1);
        clear();
        build();
        core_.show_edge_maps(i, {maps_.edge(), maps_.object(), maps_.side()});
        clock_.advance(1);
        send();
    }
}

void EdgeMapBuilder::clear() {
    maps_.clear();
    clock_.enter_loop(clear_loop_);
    clock_.iterate(timing::no_ports, core_.window_pixels());
    clock_.leave_loop();
}

void EdgeMapBuilder::build() {
    clock_.here();
    EdgeToken current = edge_token_in.read();
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
/// loop knows the end token one iteration early: then the second iteration of the last token never runs, unless the
/// configuration says so. Iterations are told many together, with a bit each for those that a second one follows; while
/// the clock lets them pass, others may put tokens where these lie. True until the end token has been read.
bool EdgeMapBuilder::take_tokens(EdgeToken& current) {
    std::size_t const available = edge_token_->peek();
    EdgeToken const* next = edge_token_->front();
    EdgeToken const* const end =
        std::find_if(next, next + available, [](EdgeToken const& token) { return token.kind == EdgeTokenKind::End; });
    bool const has_ended = end != next + available;
    std::size_t const taken = static_cast<std::size_t>(end - next) + (has_ended ? 1 : 0);
    while (next != end) {
        auto const count = static_cast<unsigned>(std::min<std::ptrdiff_t>(end - next, timing::Operation::longest_mix));
        std::uint32_t const seconds = watched_.take(maps_, current, next, count);
        current = next[count - 1];
        clock_.iterate_mixed(edge_token_->read_port(), count, seconds);
        next += count;
    }
    if (has_ended) {
        bool const second = watched_.take_last(maps_, current, core_.config.edge_map.flush_last);
        clock_.iterate(edge_token_->read_port(), 1, second ? 1 : 0);
    }
    edge_token_->consume(taken);
    return !has_ended;
}

void EdgeMapBuilder::send() {
    auto const side = static_cast<std::size_t>(maps_.side());
    clock_.enter_loop(output_loop_);
    for (std::size_t row = 0; row < side; ++row) {
        edge_map_->await_room();
        std::copy_n(maps_.edge() + row * side, side, edge_map_->reserve(side));
        edge_map_->commit(side);
        clock_.iterate(edge_map_->write_port(), side);
    }
    clock_.leave_loop();
}

}  // namespace faster
