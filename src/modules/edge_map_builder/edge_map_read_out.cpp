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

void EdgeMapReadOut::connect(ClockedFifo<std::uint8_t>& out) {
    out_ = &out;
    loop_ = clock_.loop("output");
}

void EdgeMapReadOut::send(datapath::EdgeMapPolicy const& maps, LaneRows const& rows) {
    constexpr std::size_t burst = 1024;
    if (rows.tokens() == 0) {
        clock_.advance(1);
        return;
    }
    clock_.enter_loop(loop_);
    clock_.iterate(timing::no_ports, maps.rows_read_ahead() * rows.tokens_per_row());
    for (std::size_t done = 0; done < rows.tokens();) {
        LaneRows::Run const run = rows.run(done, std::min(burst, rows.tokens() - done));
        out_->await_room();
        std::uint8_t* const bits = out_->reserve(run.tokens);
        std::copy_n(maps.edge() + run.first_pixel, run.pixels, bits);
        std::fill(bits + run.pixels, bits + run.tokens * rows.lanes(), std::uint8_t{0});
        out_->commit(run.tokens);
        clock_.iterate(out_->write_port(), run.tokens);
        done += run.tokens;
    }
    clock_.leave_loop();
}

}  // namespace faster
