#pragma once
#include <cstddef>
#include <vector>

#include "dataflow/core/memory/external_memory.hpp"
#include "dataflow/core/memory/memory_block.hpp"
#include "dataflow/core/memory/memory_load.hpp"
#include "faster/config/lane_rows.hpp"
#include "faster/config/memory_placement.hpp"
#include "faster/data/stimulus.hpp"
#include "faster/dataflow_names.hpp"

namespace faster {

/// What a raster core takes from the external memory, and puts there, for a sample (docs/memory-model.md). `i`: the
/// sample's number in its core; `sample`: in the whole job.
timing::MemoryEntry header_entry(MemoryPlacement const& placement, std::size_t i, std::size_t sample);
timing::MemoryEntry result_entry(MemoryPlacement const& placement, std::size_t i, std::size_t sample);
timing::MemoryEntry mesh_entry(MemoryPlacement const& placement, std::size_t i, std::size_t triangles);
/// Four words of the table of valid depths: the corners of the window.
timing::MemoryEntry table_entry(MemoryPlacement const& placement, std::size_t i, Stimulus const& stimulus,
                                SampleInput const& sample);
/// Pixels of the window that are in the image, or of the part of it that `rows` are.
timing::MemoryEntry pixel_entry(MemoryPlacement const& placement, std::size_t i, Stimulus const& stimulus,
                                SampleInput const& sample, LaneRows const& rows);

/// What memories on the chip hold, in the order in which they are loaded.
std::vector<timing::LoadedRange> loaded_before(MemoryPlacement const& placement, Stimulus const& stimulus);
/// Throws InputError if a mesh or an image is too large for the memory that is to hold it.
void check_fits_on_chip(MemoryPlacement const& placement, Stimulus const& stimulus);

}  // namespace faster
