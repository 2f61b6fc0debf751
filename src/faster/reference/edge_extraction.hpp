#pragma once
#include "faster/config/edge_extraction_config.hpp"
#include "faster/data/stimulus.hpp"

namespace faster::reference {

/// Flow fpga_grip: edges of the finished depth buffer by thesis eq. 2.2, written down term by term in the formats of
/// docs/modules/edge_extractor.md. Reads `maps.depth_buffer`; sets `maps.edge_map`, and `maps.object_map` to the pixels
/// in which something is drawn.
void extract_edges(EdgeExtractionConfig const& config, int depth_fraction_bits, SampleMaps& maps);

}  // namespace faster::reference
