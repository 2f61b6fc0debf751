#include "modules/scoring.hpp"

#include <algorithm>

#include "config/sweep_design.hpp"
#include "modules/core_shapes.hpp"

namespace faster {

Scoring::Scoring(CoreContext const& core, ProcessClock& clock)
    : core_(core),
      clock_(clock),
      window_sweep_(core.stimulus.window, core.stimulus.fraction.depth_buffer,
                    contour_has_depth(core.config) ? datapath::ContourDepth::own : datapath::ContourDepth::neighbour) {
    if (core.config.flow == Flow::fpga_grip)
        edge_extractor_.emplace(core, clock);
}

void Scoring::connect(ClockedFifo<std::uint8_t>* edge_map, ClockedFifo<std::uint16_t>& observed_depth,
                      ClockedFifo<std::uint8_t>& observed_edge) {
    edge_map_ = edge_map;
    observed_depth_ = &observed_depth;
    observed_edge_ = &observed_edge;
    if (edge_map_ != nullptr)
        clock_.connect_reads(*edge_map_);
    clock_.connect_reads(observed_depth);
    clock_.connect_reads(observed_edge);
    timing::Ports const edge_port = edge_map_ != nullptr ? edge_map_->read_port() : timing::Ports();
    ports_ = edge_port | observed_depth.read_port() | observed_edge.read_port();
}

void Scoring::add_loops() {
    loop_ = clock_.add_loop(loop_shape(LoopId::sweep, core_.config));
    if (edge_extractor_)
        edge_extractor_->add_loop();
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
    clock_.enter_loop(loop_);
    clock_.iterate(timing::no_ports, design.lead(rows.tokens_per_row()));
    for (std::size_t done = 0; done < rows.tokens();) {
        std::size_t n = rows.tokens() - done;
        if (edge_map_ != nullptr)
            n = std::min(n, edge_map_->peek());
        n = std::min(n, observed_depth_->peek());
        n = std::min(n, observed_edge_->peek());
        LaneRows::Run const run = rows.run(done, n);
        std::uint8_t const* const edge =
            edge_map_ != nullptr ? edge_map_->front() : edge_extractor_->edges() + run.first_pixel;
        window_sweep_.sweep(run.first_pixel, run.pixels, depth_buffer.data(), edge, observed_depth_->front(),
                            observed_edge_->front(), counters);
        clock_.iterate(ports_, run.tokens);
        if (edge_map_ != nullptr)
            edge_map_->consume(run.tokens);
        observed_depth_->consume(run.tokens);
        observed_edge_->consume(run.tokens);
        done += run.tokens;
    }
    clock_.iterate(timing::no_ports, design.tail(rows.tokens_per_row()));
    clock_.leave_loop();
}

}  // namespace faster
