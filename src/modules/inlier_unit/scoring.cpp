#include "modules/inlier_unit/scoring.hpp"

#include <algorithm>

#include "faster/config/extract_design.hpp"
#include "faster/config/sweep_design.hpp"
#include "modules/core/conditions.hpp"
#include "modules/core/described_parts.hpp"
#include "modules/core/token_widths.hpp"
#include "modules/inlier_unit/inlier_unit.hpp"

namespace faster {

void Scoring::vary(ModuleDescription& module, AcceleratorConfig const& config, Condition const& condition) {
    end_of(module, "edge_map").only_if(finds_edges_while_drawing(config));
    for (char const* const fifo : {"edge_map", "observed_depth", "observed_edge", "result"})
        end_of(module, fifo).only_if(condition);
    LoopDescription& sweep = loop_of(module, "sweep").only_if(condition);
    sweep.accesses.clear();
    sweep.accesses_memory("depth_buffer", sweep_design(config).accesses);
    module.loop("extract")
        .does("looks for an edge at one pixel of the window per iteration (flow fpga_grip)")
        .of_depth(12, config.edge_extraction.square_root_latency + config.edge_extraction.divider_latency)
        .accesses_memory("depth_buffer", extract_design(config).accesses)
        .only_if(extracts_edges(config))
        .only_if(condition);
}

void Scoring::describe(ModuleDescription& module, AcceleratorConfig const& config) {
    ModuleDescription unit = InlierUnit::describe(config);
    for (char const* const fifo : {"edge_map", "observed_depth", "observed_edge", "result"})
        module.ends.push_back(end_of(unit, fifo));
    module.loops.push_back(loop_of(unit, "sweep"));
    vary(module, config, {});
}

/// The last rows of the depth buffer, side by side, that `neighbour_access: window` keeps: two of the sweep, a token
/// per word, or all but one of eq. 2.2's neighbourhood, a pixel per word (flow fpga_grip).
void Scoring::describe_line_buffer(ModuleDescription& module, AcceleratorConfig const& config) {
    bool const extracts = config.flow == Flow::fpga_grip;  // pixel by pixel, whatever the sweep's lanes
    std::uint64_t const rows = extracts                                ? extract_design(config).line_buffer_rows
                               : sweep_design(config).has_line_buffers ? 2
                                                                       : 0;
    if (rows == 0)
        return;
    LaneRows const tokens(config.window, config.inlier_unit.sweep_lanes);
    std::uint64_t const words = extracts ? static_cast<std::uint64_t>(config.window) : tokens.tokens_per_row();
    module.line_buffer({"line_buffers", words, rows * (extracts ? 1 : tokens.lanes()) * wires::depth});
}

Scoring::Scoring(CoreContext const& core, ProcessClock& clock)
    : core_(core),
      clock_(clock),
      window_sweep_(core.stimulus.window, core.stimulus.fraction.depth_buffer,
                    contour_has_depth(core.config) ? datapath::ContourDepth::own : datapath::ContourDepth::neighbour) {
    if (core.config.flow == Flow::fpga_grip)
        edge_extractor_.emplace(core, clock);
    if (counts_hidden(core.config.inlier_unit))
        hidden_sweep_.emplace(core.stimulus.window, core.stimulus.fraction.depth_buffer);
}

void Scoring::connect(ClockedFifo<std::uint8_t>* edge_map, ClockedFifo<std::uint16_t>& observed_depth,
                      ClockedFifo<std::uint8_t>& observed_edge) {
    sweep_.connect(clock_, "sweep", edge_map, &observed_depth, &observed_edge);
}

/// In a region nothing is known of the rest of the window: its valid depths come to the host another way.
void Scoring::score(std::size_t sample, std::vector<std::uint16_t>& depth_buffer, PixelBox const& box,
                    SampleCounters& counters) {
    if (edge_extractor_) {
        edge_extractor_->extract(sample, depth_buffer, box);
        clock_.advance(1);
    }
    LaneRows const rows = core_.rows_of(box);
    if (rows.tokens() == 0)
        clock_.advance(1);
    else
        sweep(depth_buffer, rows, counters);
    if (!core_.sweeps_touched())
        return;
    counters.valid_depth = 0;
    if (core_.config.inlier_unit.clearing == MapClearing::on_read_out)
        forget(depth_buffer, box);
}

/// All of the box is "far" again, as the rest of this buffer still is: the sample drew nowhere else.
void Scoring::forget(std::vector<std::uint16_t>& depth_buffer, PixelBox const& box) const {
    auto const side = static_cast<std::size_t>(core_.stimulus.window);
    for (auto row = static_cast<std::size_t>(box.first_row); row < static_cast<std::size_t>(box.end_row); ++row)
        std::fill_n(depth_buffer.begin() + static_cast<std::ptrdiff_t>(row * side) + box.first_col, box.cols(),
                    far_depth_code);
}

void Scoring::sweep(std::vector<std::uint16_t> const& depth_buffer, LaneRows const& rows, SampleCounters& counters) {
    SweepDesign const design = sweep_design(core_.config);
    sweep_.enter();
    clock_.iterate(timing::no_ports, design.lead(rows.tokens_per_row()));
    sweep_.take(rows.tokens(), [&](std::size_t first, std::size_t most, std::uint8_t const* edge,
                                   std::uint16_t const* observed_depth, std::uint8_t const* observed_edge) {
        LaneRows::Run const run = rows.run(first, most);
        if (edge_extractor_)
            edge = edge_extractor_->edges() + run.first_pixel;
        window_sweep_.sweep(run.first_pixel, run.pixels, depth_buffer.data(), edge, observed_depth, observed_edge,
                            counters);
        if (hidden_sweep_)
            hidden_sweep_->sweep(run.first_pixel, run.pixels, depth_buffer.data(), observed_depth, counters);
        return run.tokens;
    });
    clock_.iterate(timing::no_ports, design.tail(rows.tokens_per_row()));
    sweep_.leave();
}

}  // namespace faster
