#pragma once
#include <optional>
#include <vector>

#include "channels/token_loop.hpp"
#include "faster/data/tokens.hpp"
#include "faster/dataflow_names.hpp"
#include "modules/core/core_context.hpp"
#include "modules/edge_extractor/edge_extractor.hpp"
#include "modules/inlier_unit/hidden_pixels.hpp"
#include "modules/inlier_unit/window_sweep.hpp"

namespace faster {

/// Compares a drawn depth buffer with the observation: part of the InlierUnitVariant's process, or of one of its own
/// (InlierSweep).
///   in    edge_map, observed_depth, observed_edge  W x W each, row-major, `sweep_lanes` pixels of a row per token
///   time  in flow fpga_grip loop `extract` and a cycle; loop `sweep`
/// Source: thesis 4.1.3 and A.3; docs/function.md#inlierunit, docs/timing-model.md#sources-of-time.
class Scoring {
  public:
    /// Changes the InlierUnit's ends and loops of this part as the configuration says, and adds those of the flow
    /// fpga_grip. `condition`: under which the module has them.
    static void vary(ModuleDescription& module, AcceleratorConfig const& config, Condition const& condition);
    /// Gives these ends and loops to the module whose process this part is.
    static void describe(ModuleDescription& module, AcceleratorConfig const& config);
    /// Adds the rows of the depth buffer that `neighbour_access: window` keeps.
    static void describe_line_buffer(ModuleDescription& module, AcceleratorConfig const& config);

    Scoring(CoreContext const& core, ProcessClock& clock);
    /// When the process's clock is connected. `edge_map`: null in flow fpga_grip.
    void connect(ClockedFifo<std::uint8_t>* edge_map, ClockedFifo<std::uint16_t>& observed_depth,
                 ClockedFifo<std::uint8_t>& observed_edge);
    /// Adds to the counters of a sample what a box of pixels has, and clears the box, if that is what clears a region.
    void score(std::size_t sample, std::vector<std::uint16_t>& depth_buffer, PixelBox const& box,
               SampleCounters& counters);

  private:
    void forget(std::vector<std::uint16_t>& depth_buffer, PixelBox const& box) const;
    void sweep(std::vector<std::uint16_t> const& depth_buffer, LaneRows const& rows, SampleCounters& counters);

    CoreContext const& core_;
    ProcessClock& clock_;
    datapath::WindowSweep window_sweep_;
    std::optional<datapath::HiddenSweep> hidden_sweep_;  ///< inlier_unit.hidden counted
    std::optional<EdgeExtractor> edge_extractor_;        ///< flow fpga_grip
    TokenLoop<Reads<std::uint8_t, std::uint16_t, std::uint8_t>> sweep_;
};

}  // namespace faster
