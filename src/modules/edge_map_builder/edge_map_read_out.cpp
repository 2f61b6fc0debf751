#include "modules/edge_map_builder/edge_map_read_out.hpp"

#include <algorithm>

namespace faster {

namespace {

constexpr PixelOffset own{0, 0};
constexpr PixelOffset above{-1, 0};
constexpr PixelOffset below{1, 0};

AccessPattern pattern_of(std::uint64_t touches) {
    AccessPattern pattern;
    if ((touches & map_touch::read_own) != 0)
        pattern.reads.push_back(own);
    if ((touches & map_touch::read_vertical) != 0)
        pattern.reads.insert(pattern.reads.end(), {above, below});
    if ((touches & map_touch::write_own) != 0)
        pattern.writes.push_back(own);
    if ((touches & map_touch::write_vertical) != 0)
        pattern.writes.insert(pattern.writes.end(), {above, below});
    return pattern;
}

}  // namespace

void EdgeMapReadOut::touch(LoopDescription& loop, PerMap const& touches, int lanes) {
    if (touches.edge_map != 0)
        loop.accesses_memory("edge_map", widened(pattern_of(touches.edge_map), lanes));
    if (touches.object_map != 0)
        loop.accesses_memory("object_map", widened(pattern_of(touches.object_map), lanes));
}

void EdgeMapReadOut::describe_output(ModuleDescription& module, AcceleratorConfig const& config, Condition condition) {
    module.writes_to("edge_map")
        .carries("edge bits from the edge map builder to the inlier unit")
        .of_bits(static_cast<unsigned>(config.inlier_unit.sweep_lanes))
        .leaves("output", 2)
        .only_if(std::move(condition));
}

LoopDescription& EdgeMapReadOut::describe_loop(ModuleDescription& module, AcceleratorConfig const& config) {
    LoopDescription& loop =
        module.loop("output").does("sends one token of edge bits per iteration").of_depth(3).writes_to({"edge_map"});
    touch(loop, output_touches(config.edge_map), config.inlier_unit.sweep_lanes);
    return loop;
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
