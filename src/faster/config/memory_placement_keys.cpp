
#include "dataflow/run/config/choice_names.hpp"
#include "dataflow/run/config/key_builders.hpp"
#include "faster/config/faster_config.hpp"
#include "faster/config/faster_keys.hpp"
#include "faster/dataflow_names.hpp"

namespace faster {
namespace {

constexpr char const* this_project = "this project";
constexpr std::int64_t most_address = (std::int64_t{1} << 40) - 1;

}  // namespace

Keys memory_placement_keys() {
    Keys keys;
    auto memory =
        key_section(keys, "accelerator.memory", &FasterConfig::accelerator, &AcceleratorConfig::memory_placement);
    memory.choice(
        "mesh", "",
        "Whether the vertex transform fetches the mesh for every sample, or has it in block RAMs of its core.",
        this_project, &MemoryPlacement::mesh);
    memory.choice("observation", "",
                  "Whether the observation reader fetches each sample's window, or the whole image is in block RAMs.",
                  this_project, &MemoryPlacement::observation);
    memory.integer("observation_copies", "",
                   "How often an observation on the chip is there; the cores share the copies' ports.", this_project,
                   {1, 1024}, &MemoryPlacement::observation_copies);
    keys.back().decides_time = true;
    memory.integer("mesh_triangles", "triangles", "What a mesh on the chip has room for.", this_project, {1, 1'048'576},
                   &MemoryPlacement::mesh_triangles);
    memory.integer("observation_width", "px", "Width of the image that an observation on the chip has room for.",
                   this_project, {1, 4096}, &MemoryPlacement::observation_width);
    memory.integer("observation_height", "px", "Height of the image that an observation on the chip has room for.",
                   this_project, {1, 4096}, &MemoryPlacement::observation_height);
    auto const add_address = [&memory](char const* name, std::string const& what,
                                       std::uint64_t MemoryPlacement::*address) {
        memory.integer(name, "", "Address of " + what + ".", this_project, {0, most_address}, address);
    };
    add_address("mesh_address", "the mesh, 24 bytes per triangle", &MemoryPlacement::mesh_address);
    add_address("image_address", "the observation, row by row, 2 bytes per pixel", &MemoryPlacement::image_address);
    add_address("table_address", "the table of valid depths, 4 bytes per word, which only sweep_region touched reads",
                &MemoryPlacement::table_address);
    add_address("header_address", "the headers, 64 bytes per sample", &MemoryPlacement::header_address);
    add_address("result_address", "the results, 32 bytes per sample", &MemoryPlacement::result_address);
    return keys;
}

}  // namespace faster
