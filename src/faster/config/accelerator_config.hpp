#pragma once
#include <string>

#include "dataflow/core/machine/machine_settings.hpp"
#include "faster/config/edge_extraction_config.hpp"
#include "faster/config/edge_map_config.hpp"
#include "faster/config/inlier_unit_config.hpp"
#include "faster/config/memory_placement.hpp"
#include "faster/config/rasterizer_config.hpp"
#include "faster/data/fixed_point.hpp"
#include "faster/dataflow_names.hpp"

namespace faster {

/// How contours get into the score; key `accelerator.flow`.
enum class Flow {
    faster,     ///< while triangles are drawn: edge tokens become an edge map (the thesis's FASTER)
    fpga_grip,  ///< afterwards: eq. 2.2 on the finished depth buffer (the thesis's baseline FPGA_GRIP)
};

/// The machine: keys `accelerator.*`. Defaults are the thesis's final design as docs/timing-model.md times it; those of
/// FIFOs, loops and block RAMs stand in the modules' descriptions.
struct AcceleratorConfig : MachineSettings {
    AcceleratorConfig() {
        cores = 10;                               // accelerator.raster_cores
        fifo_rules = FifoGeneration::vivado_hls;  // the thesis's tool
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
