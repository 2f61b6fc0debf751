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
    std::uint8_t const port = edge_token_->read_port();
    bool ended = false;
    std::size_t taken = 0;
    while (taken < available && !ended) {
        std::size_t const run = take_object_run(current, next + taken, available - taken);
        if (run > 0) {
            taken += run;
            current = next[taken - 1];
            clock_.iterate(port, run, 1);
            continue;
        }
        ended = next[taken].kind == EdgeTokenKind::End;
        bool const second = maps_.needs_second(current) && (!ended || core_.config.flush_last);
        maps_.take(current);
        if (second)
            maps_.take_second(current);
        current = next[taken++];
        clock_.iterate(port, 1, second ? 1 : 0);  // in lockstep the tokens may move meanwhile: there is one
    }
    edge_token_->consume(taken);
    return !ended;
}

/// Takes `current` and those that follow it side by side, if they are pixels of the object in one row of the window.
/// Returns how many it took, each of which took two iterations and read one token; not one before the end token.
std::size_t EdgeMapBuilder::take_object_run(EdgeToken const& current, EdgeToken const* next, std::size_t available) {
    if (!maps_.needs_second(current) || next[0].kind == EdgeTokenKind::End)
        return 0;
    int const step = next[0].col - current.col;
    std::size_t run = 1;
    if (step == 1 || step == -1)
        for (int col = current.col + step; run < available; ++run, col += step) {
            EdgeToken const& token = next[run - 1];
            if (token.row != current.row || token.col != col || !maps_.needs_second(token) ||
                next[run].kind == EdgeTokenKind::End)
                break;
        }
    int const last = current.col + step * static_cast<int>(run - 1);
    maps_.take_run(current.row, std::min<int>(current.col, last), std::max<int>(current.col, last));
    return run;
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
