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
    : CoreModule(name, core),
      depth_unit_(core.stimulus.fraction),
      window_sweep_(core.stimulus.window, core.stimulus.fraction.depth_buffer),
      depth_buffer_(core.window_pixels()) {}

void InlierUnit::connect() {
    fragment_.connect(clock_, "fragment", &channel_of(fragment_depth_in), &channel_of(fragment_index_in),
                      &channel_of(command_in));
    sweep_.connect(clock_, "sweep", &channel_of(edge_map_in), &channel_of(observed_depth_in),
                   &channel_of(observed_edge_in));
    distances_ = clock_.write_distances("fragment", "depth_buffer");
}

void InlierUnit::work(std::size_t i) {
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

void InlierUnit::clear() {
    std::fill(depth_buffer_.begin(), depth_buffer_.end(), far_depth_code);
    clock_.pipeline("clear", depth_buffer_.size());
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
    FragmentDrawing const fragments{depth_unit_, depth_buffer_.data(), static_cast<unsigned>(core_.stimulus.window),
                                    reciprocal};
    with_watcher(distances_, [&](auto& watcher) {
        fragment_.run_while([&](std::int64_t z_sum, FragmentIndex const& pixel, Command next) {
            watcher.next_iteration();
            counters_.valid_raster += fragments.draw(z_sum, pixel, watcher) ? 1U : 0U;
            command = next;
            return next == Command::Fragment;
        });
    });
    return command;
}

void InlierUnit::sweep() {
    sweep_.run(depth_buffer_.size(), [&](std::size_t first, std::size_t count, std::uint8_t const* edge,
                                         std::uint16_t const* observed_depth, std::uint8_t const* observed_edge) {
        window_sweep_.sweep(first, count, depth_buffer_.data(), edge, observed_depth, observed_edge, counters_);
    });
}

}  // namespace faster
