#include "modules/edge_map_builder/edge_map_read_out.hpp"

#include <algorithm>

#include "modules/core/described_parts.hpp"
#include "modules/edge_map_builder/edge_map_builder.hpp"
#include "modules/edge_map_builder/map_accesses.hpp"

namespace faster {

FifoEnd EdgeMapReadOut::described_end(AcceleratorConfig const& config) {
    ModuleDescription builder = EdgeMapBuilder::describe(config.window);
    return end_of(builder, "edge_map").of_bits(static_cast<unsigned>(config.inlier_unit.sweep_lanes));
}

LoopDescription EdgeMapReadOut::described_loop(AcceleratorConfig const& config) {
    ModuleDescription builder = EdgeMapBuilder::describe(config.window);
    return touch_maps(loop_of(builder, "output"), output_touches(config.edge_map), config.inlier_unit.sweep_lanes);
}

void EdgeMapReadOut::connect(ClockedFifo<std::uint8_t>& out) { output_.connect(clock_, "output", &out); }

void EdgeMapReadOut::send(datapath::EdgeMapPolicy const& maps, LaneRows const& rows) {
    if (rows.tokens() == 0) {
        clock_.advance(1);
        return;
    }
    output_.enter();
    clock_.iterate(timing::no_ports, maps.rows_read_ahead() * rows.tokens_per_row());
    output_.take(rows.tokens(), [&](std::size_t first, std::size_t most, std::uint8_t* bits) {
        LaneRows::Run const run = rows.run(first, most);
        std::copy_n(maps.edge() + run.first_pixel, run.pixels, bits);
        std::fill(bits + run.pixels, bits + run.tokens * rows.lanes(), std::uint8_t{0});
        return run.tokens;
    });
    output_.leave();
}

}  // namespace faster
