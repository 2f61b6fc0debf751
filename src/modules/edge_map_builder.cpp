#include "modules/edge_map_builder.hpp"

#include <algorithm>

#include "channels/port_binding.hpp"
#include "modules/core_shapes.hpp"

namespace faster {

EdgeMapBuilder::EdgeMapBuilder(sc_core::sc_module_name const& name, CoreContext const& core)
    : sc_module(name), core_(core), clock_(core.timing, basename(), core.time_base), maps_(core.stimulus.window) {
    SC_THREAD(run);
}

void EdgeMapBuilder::end_of_elaboration() {
    edge_token_ = &channel_of(edge_token_in);
    clock_.connect_reads(*edge_token_);
    clock_.connect_writes(channel_of(edge_map_out));
    clear_loop_ = clock_.add_loop(loop_shape(LoopId::edge_clear, core_.config));
    token_loop_ = clock_.add_loop(loop_shape(LoopId::token, core_.config));
    output_loop_ = clock_.add_loop(loop_shape(LoopId::output, core_.config), {&channel_of(edge_map_out)});
}

void EdgeMapBuilder::run() {
    for (std::size_t i = 0; i < core_.sample_count; ++i) {
        clock_.advance(1);
        clear();
        build();
        if (core_.probe != nullptr)
            core_.probe->edge_maps_done(core_.first_sample + i, maps_);
        clock_.advance(1);
        output();
    }
}

void EdgeMapBuilder::clear() {
    maps_.clear();
    clock_.enter_loop(clear_loop_);
    clock_.iterate(0, core_.window_pixels());
    clock_.leave_loop();
}

void EdgeMapBuilder::build() {
    EdgeToken current = edge_token_in.read();
    clock_.advance(1);
    if (current.kind == EdgeTokenKind::End) {
        clock_.advance(1);
        return;
    }
    clock_.enter_loop(token_loop_);
    while (take_tokens(current)) {
    }
    clock_.leave_loop();
}

/// Works off the tokens at hand. Every iteration that consumes `current` reads the next token in its step, so that the
/// loop knows the end token one iteration early. True until it has been read.
bool EdgeMapBuilder::take_tokens(EdgeToken& current) {
    std::size_t const available = edge_token_->peek();
    EdgeToken const* const next = edge_token_->front();
    std::size_t taken = 0;
    while (taken < available && current.kind != EdgeTokenKind::End) {
        std::size_t const most = std::min<std::size_t>(available - taken, timing::Operation::longest_mix);
        taken += take_some(current, next + taken, static_cast<unsigned>(most));
    }
    edge_token_->consume(taken);
    return current.kind != EdgeTokenKind::End;
}

/// Takes up to `most` tokens, and tells the clock of their iterations together, a bit each that says whether a second
/// one followed. A second iteration that is due when the end token has been read only runs if the configuration says so.
unsigned EdgeMapBuilder::take_some(EdgeToken& current, EdgeToken const* next, unsigned most) {
    datapath::EdgeMaps::Pen const pen(maps_);
    EdgeToken token = current;
    std::uint32_t seconds = 0;
    unsigned taken = 0;
    for (; taken < most && next[taken].kind != EdgeTokenKind::End; token = next[taken++])
        if (pen.covers(token))
            seconds |= pen.take_whole(token) << taken;
    if (taken < most) {
        bool const second = core_.config.flush_last && maps_.needs_second(token);
        maps_.take(token);
        if (second)
            maps_.take_second(token);
        seconds |= (second ? 1U : 0U) << taken;
        token = next[taken++];
    }
    current = token;
    clock_.iterate_mixed(edge_token_->read_port(), taken, seconds);
    return taken;
}

void EdgeMapBuilder::output() {
    constexpr std::size_t burst = 1024;
    auto& out = channel_of(edge_map_out);
    std::size_t const pixels = core_.window_pixels();
    clock_.enter_loop(output_loop_);
    for (std::size_t done = 0; done < pixels;) {
        std::size_t const n = std::min(burst, pixels - done);
        out.await_room();
        maps_.edge().unpack(done, n, out.reserve(n));
        out.commit(n);
        clock_.iterate(out.write_port(), n);
        done += n;
    }
    clock_.leave_loop();
}

}  // namespace faster
