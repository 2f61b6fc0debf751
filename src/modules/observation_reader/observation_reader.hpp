#pragma once
#include <optional>
#include <systemc>

#include "channels/port_binding.hpp"
#include "channels/token_loop.hpp"
#include "faster/data/tokens.hpp"
#include "faster/dataflow_names.hpp"
#include "modules/core/core_module.hpp"
#include "modules/inlier_unit/valid_depth_table.hpp"

namespace faster {

/// Reads the observed scene under a sample's window.
///   in    sample_observation_in  one header per sample
///         region_in              sweep_region touched: corners of the box of pixels to be read
///   out   observed_depth_out, observed_edge_out: W x W codes and bits per sample, row-major, together, `sweep_lanes`
///         pixels of a row per token; 0 outside the image
///         valid_depth_out        sweep_region touched: how many pixels of the window have a valid depth
///   time  loop `read`, one token per iteration; touched: four iterations before, for valid_depth
/// Source: docs/function.md#samples-and-cores, docs/timing-model.md#sources-of-time.
class ObservationReader : public CoreModule {
  public:
    sc_core::sc_fifo_in<SampleHeader> sample_observation_in{"sample_observation_in"};
    OptionalFifoIn<FragmentIndex> region_in{"region_in"};  ///< unbound unless touched
    OptionalFifoOut<std::uint64_t> valid_depth_out{"valid_depth_out"};
    sc_core::sc_fifo_out<std::uint16_t> observed_depth_out{"observed_depth_out"};
    sc_core::sc_fifo_out<std::uint8_t> observed_edge_out{"observed_edge_out"};

    static ModuleDescription describe(AcceleratorConfig const& config);

    ObservationReader(sc_core::sc_module_name const& name, CoreContext const& core);

  private:
    void connect() override;
    void start() override;
    void work(std::size_t i) override;
    static void add_stream(AcceleratorConfig const& config, ModuleDescription& module);
    timing::MemoryEntry pixels_of(std::size_t i, LaneRows const& rows) const;
    void send_valid_depth(std::size_t i);
    PixelBox receive_region();
    void send_pixels(SampleHeader const& header, LaneRows const& rows);
    template <class Pixel>
    void copy_row(Image<Pixel> const& image, std::int64_t row, std::int64_t first_col, std::int64_t begin,
                  std::size_t pixels, Pixel* out) const;

    std::optional<datapath::ValidDepthTable> valid_depth_;  ///< sweep_region touched
    // Loop `read`, by what an iteration accesses.
    TokenLoop<Reads<>, Writes<std::uint16_t, std::uint8_t>> read_;
    TokenLoop<Reads<>> table_read_;
};

}  // namespace faster
