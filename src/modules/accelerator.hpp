#pragma once
#include <memory>
#include <vector>

#include "faster/run_config.hpp"
#include "modules/raster_core.hpp"

namespace faster {

/// N raster cores that share nothing but the observed scene and the list of samples.
class Accelerator : public sc_core::sc_module {
  public:
    /// `config` and `stimulus` must outlive the accelerator.
    Accelerator(sc_core::sc_module_name const& name, AcceleratorConfig const& config, Stimulus const& stimulus,
                Engine engine);

    /// Which samples core `k` gets: equal shares in order, the last cores may get fewer, or none (SPEC section 1).
    static CoreShare share_of(std::size_t core, std::size_t cores, std::size_t samples);

    std::vector<std::unique_ptr<RasterCore>> const& cores() const { return cores_; }

  private:
    std::vector<std::unique_ptr<RasterCore>> cores_;
};

}  // namespace faster
