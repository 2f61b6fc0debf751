#include "modules/inlier_unit/inlier_unit.hpp"

#include <algorithm>

#include "channels/port_binding.hpp"
#include "modules/core/loop_branches.hpp"
#include "modules/core/token_widths.hpp"
#include "modules/core/watching.hpp"

namespace faster {

ModuleDescription InlierUnit::describe(AcceleratorConfig const& config) {
    constexpr PixelOffset own{0, 0}, below{1, 0}, above{-1, 0}, right{0, 1}, left{0, -1};
    ModuleDescription module("inlier_unit");
    for (char const* const fifo : {"area_reciprocal", "fragment_depth", "fragment_index", "command", "edge_map",
                                   "observed_depth", "observed_edge"})
        module.reads_from(fifo);
    module.writes_to("result")
        .carries("counters of a sample from the inlier unit to the result collector")
        .of_bits(wires::result(config));
    module.loop("clear")
        .does("fills one word of the depth buffer, or one of every bank, per iteration")
        .of_depth(2)
        .accesses_memory("depth_buffer", {{}, {own}});
    add_branches(module.loop("fragment").does("takes one fragment or group per iteration").of_depth(10), "depth_buffer",
                 {{{own}, {own}}}, AccessStages{7, 9});
    module.loop("sweep")
        .does("judges one token of pixels per iteration")
        .of_depth(8)
        .accesses_memory("depth_buffer", {{below, above, right, left, own}, {}});
    auto const side = static_cast<std::uint64_t>(config.window);
    module.memory("depth_buffer")
        .holds("depth buffer of the window")
        .of_words(side, side, wires::depth)
        .sized_by("accelerator.window");
    return module;
}

InlierUnit::InlierUnit(sc_core::sc_module_name const& name, CoreContext const& core)
    : sc_module(name),
      core_(core),
      clock_(core.core, "inlier_unit"),
      depth_unit_(core.stimulus.fraction),
      window_sweep_(core.stimulus.window, core.stimulus.fraction.depth_buffer),
      depth_buffer_(core.window_pixels()) {
    SC_THREAD(run);
}

void InlierUnit::end_of_elaboration() {
    clock_.connect_all();
    fragment_depth_ = &channel_of(fragment_depth_in);
    fragment_index_ = &channel_of(fragment_index_in);
    command_ = &channel_of(command_in);
    edge_map_ = &channel_of(edge_map_in);
    observed_depth_ = &channel_of(observed_depth_in);
    observed_edge_ = &channel_of(observed_edge_in);
    fragment_ports_ = fragment_depth_->read_port() | fragment_index_->read_port() | command_->read_port();
    sweep_ports_ = edge_map_->read_port() | observed_depth_->read_port() | observed_edge_->read_port();
    clear_loop_ = clock_.loop("clear");
    fragment_loop_ = clock_.loop("fragment");
    sweep_loop_ = clock_.loop("sweep");
    watcher_ = clock_.write_distances("fragment", "depth_buffer");
}

void InlierUnit::run() {
    for (std::size_t i = 0; i < core_.sample_count; ++i) {
        clock_.begin_sample();
        counters_ = SampleCounters{};
        clock_.advance(1);
        clear();
        draw_triangles();
        core_.show_depth_buffer(i, depth_buffer_);
        clock_.advance(1);
        sweep();
        clock_.here();
        result_out.write(counters_);
        clock_.advance(1);
    }
}

void InlierUnit::clear() {
    std::fill(depth_buffer_.begin(), depth_buffer_.end(), far_depth_code);
    clock_.enter_loop(clear_loop_);
    clock_.iterate(timing::no_ports, depth_buffer_.size());
    clock_.leave_loop();
}

void InlierUnit::draw_triangles() {
    clock_.here();
    Command command = command_in.read();
    clock_.advance(1);
    while (command == Command::Triangle) {
        std::uint64_t reciprocal = 0;
        {
            Step const step(clock_);
            reciprocal = area_reciprocal_in.read();
            command = command_in.read();
        }
        clock_.advance(1);
        command = draw_fragments(reciprocal, command);
    }
}

/// The fragments of one triangle. `command` is read one ahead of them; returns the first that is no Fragment.
Command InlierUnit::draw_fragments(std::uint64_t reciprocal, Command command) {
    if (command != Command::Fragment) {
        clock_.advance(1);
        return command;
    }
    clock_.enter_loop(fragment_loop_);
    if (watcher_ != nullptr)
        watcher_->enter();
    while (command == Command::Fragment) {
        std::size_t const at_hand = std::min({fragment_depth_->peek(), fragment_index_->peek(), command_->peek()});
        FragmentBurst const fragments{fragment_depth_->front(), fragment_index_->front(), command_->front(), at_hand,
                                      reciprocal};
        std::size_t const taken = with_watcher(watcher_, [&](auto& watcher) {
            return fragments.draw(depth_unit_, depth_buffer_.data(), static_cast<unsigned>(core_.stimulus.window),
                                  command, counters_.valid_raster, watcher);
        });
        clock_.iterate(fragment_ports_, taken);
        fragment_depth_->consume(taken);
        fragment_index_->consume(taken);
        command_->consume(taken);
    }
    clock_.leave_loop();
    return command;
}

void InlierUnit::sweep() {
    clock_.enter_loop(sweep_loop_);
    for (std::size_t done = 0; done < depth_buffer_.size();) {
        std::size_t const left = depth_buffer_.size() - done;
        std::size_t const n = std::min({left, edge_map_->peek(), observed_depth_->peek(), observed_edge_->peek()});
        window_sweep_.sweep(done, n, depth_buffer_.data(), edge_map_->front(), observed_depth_->front(),
                            observed_edge_->front(), counters_);
        clock_.iterate(sweep_ports_, n);
        edge_map_->consume(n);
        observed_depth_->consume(n);
        observed_edge_->consume(n);
        done += n;
    }
    clock_.leave_loop();
}

}  // namespace faster
