#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "channels/dataflow_core.hpp"
#include "channels/process_clock.hpp"
#include "faster/config/accelerator_config.hpp"
#include "faster/config/lane_rows.hpp"
#include "faster/data/stimulus.hpp"
#include "faster/data/token_fields.hpp"
#include "faster/dataflow_names.hpp"

namespace faster {

/// Contour and covered pixels of a sample, `side` x `side` bytes each, row-major, 0 or 1.
struct EdgeMapView {
    std::uint8_t const* edge;
    std::uint8_t const* object;
    int side;
};

/// Sees what a sample left in the maps, before the next sample clears them. Called from the modules' processes.
class SampleProbe {
  public:
    virtual ~SampleProbe() = default;
    virtual void edge_maps_done(std::size_t sample, EdgeMapView const& maps) = 0;
    virtual void depth_buffer_done(std::size_t sample, std::vector<std::uint16_t> const& depth_buffer) = 0;
};

/// What all modules of one raster core share: the configuration, the core's part of the workload, the core itself.
struct CoreContext {
    AcceleratorConfig const& config;
    Stimulus const& stimulus;
    DataflowCore& core;
    std::size_t first_sample = 0;
    std::size_t sample_count = 0;
    SampleProbe* probe = nullptr;  ///< may be null: see show_edge_maps(), show_depth_buffer()

    SampleInput const& sample(std::size_t i) const { return stimulus.samples[first_sample + i]; }
    /// The window as the tokens of edge_map, observed_depth and observed_edge carry it.
    LaneRows window_rows() const { return {stimulus.window, config.inlier_unit.sweep_lanes}; }
    /// The part of it that a box of pixels covers.
    LaneRows rows_of(PixelBox const& box) const { return {stimulus.window, config.inlier_unit.sweep_lanes, box}; }
    bool sweeps_touched() const { return config.inlier_unit.sweep_region == SweepRegion::touched; }
    PixelBox whole_window() const { return {0, 0, stimulus.window, stimulus.window}; }
    void show_edge_maps(std::size_t i, EdgeMapView const& maps) const {
        if (probe != nullptr)
            probe->edge_maps_done(first_sample + i, maps);
    }
    void show_depth_buffer(std::size_t i, std::vector<std::uint16_t> const& depth_buffer) const {
        if (probe != nullptr)
            probe->depth_buffer_done(first_sample + i, depth_buffer);
    }
    std::size_t window_pixels() const {
        return static_cast<std::size_t>(stimulus.window) * static_cast<std::size_t>(stimulus.window);
    }
};

}  // namespace faster
