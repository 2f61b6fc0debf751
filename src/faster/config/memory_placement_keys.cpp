
#include "dataflow/run/config/choice_names.hpp"
#include "dataflow/run/config/key_builders.hpp"
#include "faster/config/faster_config.hpp"
#include "faster/config/faster_keys.hpp"
#include "faster/dataflow_names.hpp"

namespace faster {
namespace {

using Make = KeyMaker<FasterConfig>;

constexpr char const* this_project = "this project";
constexpr std::int64_t most_address = (std::int64_t{1} << 40) - 1;

template <class Field> Key address_key(std::string const& name, std::string const& what, Field field) {
    return Make::integer_key({"accelerator.memory." + name, "", "Address of " + what + ".", this_project},
                             {0, most_address}, field);
}

}  // namespace

Keys memory_placement_keys() {
    Keys keys;
    keys.push_back(Make::choice_key(
        {"accelerator.memory.mesh", "",
         "Whether the vertex transform fetches the mesh for every sample, or has it in block RAMs of its core.",
         this_project},
        [](auto& config) -> auto& { return config.accelerator.memory_placement.mesh; }));
    keys.push_back(Make::choice_key(
        {"accelerator.memory.observation", "",
         "Whether the observation reader fetches each sample's window, or the whole image is in block RAMs.",
         this_project},
        [](auto& config) -> auto& { return config.accelerator.memory_placement.observation; }));
    keys.push_back(of_time(Make::integer_key(
        {"accelerator.memory.observation_copies", "",
         "How often an observation on the chip is there; the cores share the copies' ports.", this_project},
        {1, 1024}, [](auto& config) -> auto& { return config.accelerator.memory_placement.observation_copies; })));
    keys.push_back(Make::integer_key(
        {"accelerator.memory.mesh_triangles", "triangles", "What a mesh on the chip has room for.", this_project},
        {1, 1'048'576}, [](auto& config) -> auto& { return config.accelerator.memory_placement.mesh_triangles; }));
    keys.push_back(Make::integer_key(
        {"accelerator.memory.observation_width", "px",
         "Width of the image that an observation on the chip has room for.", this_project},
        {1, 4096}, [](auto& config) -> auto& { return config.accelerator.memory_placement.observation_width; }));
    keys.push_back(Make::integer_key(
        {"accelerator.memory.observation_height", "px",
         "Height of the image that an observation on the chip has room for.", this_project},
        {1, 4096}, [](auto& config) -> auto& { return config.accelerator.memory_placement.observation_height; }));
    keys.push_back(address_key(
        "mesh_address", "the mesh, 24 bytes per triangle",
        [](auto& config) -> auto& { return config.accelerator.memory_placement.mesh_address; }));
    keys.push_back(address_key(
        "image_address", "the observation, row by row, 2 bytes per pixel",
        [](auto& config) -> auto& { return config.accelerator.memory_placement.image_address; }));
    keys.push_back(address_key(
        "table_address", "the table of valid depths, 4 bytes per word, which only sweep_region touched reads",
        [](auto& config) -> auto& { return config.accelerator.memory_placement.table_address; }));
    keys.push_back(address_key(
        "header_address", "the headers, 64 bytes per sample",
        [](auto& config) -> auto& { return config.accelerator.memory_placement.header_address; }));
    keys.push_back(address_key(
        "result_address", "the results, 32 bytes per sample",
        [](auto& config) -> auto& { return config.accelerator.memory_placement.result_address; }));
    return keys;
}

}  // namespace faster
