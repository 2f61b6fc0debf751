#pragma once
#include <string>

#include "common/edge_extraction_config.hpp"
#include "common/edge_map_config.hpp"
#include "common/fixed_point.hpp"
#include "common/flow.hpp"
#include "common/inlier_unit_config.hpp"
#include "common/memory_placement.hpp"
#include "common/rasterizer_config.hpp"
#include "kernel/machine/machine_settings.hpp"

namespace faster {

/// The machine: keys `accelerator.*`. Defaults are the thesis's final design as SPEC section 3 times it; those of
/// FIFOs, loops and block RAMs stand in the modules' descriptions.
struct AcceleratorConfig : MachineSettings {
    AcceleratorConfig() {
        cores = 10;                         // accelerator.raster_cores
        fifo_rules = FifoGeneration::spec;  // by which all its figures were measured
    }

    std::string architecture = "faster";  ///< name of the preset that the other keys start from
    int window = 200;                     ///< side of the square window [px]
    FractionBits fraction_bits;
    Flow flow = Flow::faster;
    EdgeMapConfig edge_map;
    EdgeExtractionConfig edge_extraction;
    RasterizerConfig rasterizer;
    InlierUnitConfig inlier_unit;
    MemoryPlacement memory_placement;
};

}  // namespace faster
