#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "faster/data/camera.hpp"
#include "faster/workload/depth_image.hpp"
#include "poses/bop/dataset.hpp"
#include "poses/experiments/experiment_file.hpp"

namespace faster::experiments {

/// A cluttered table with an object to look for.
struct MadeScene {
    std::vector<bop::GroundTruth> objects;  ///< the one to look for is the first
    workload::DepthImage depth;             ///< with the sensor's noise
    bool is_as_wished = true;               ///< as much of the first is visible as was drawn, and all is in the image
};

/// What a scene is made from.
struct SceneWish {
    int obj_id = 1;                       ///< of the object to look for
    std::array<double, 2> visible{0, 1};  ///< its share that is to be seen, drawn between these
    std::uint64_t seed = 1;
    std::uint64_t number = 0;  ///< of the scene; another seed and number, another scene
};

/// Five to seven objects of different classes on a table that the camera looks down on by 20 to 50 degrees, each lying
/// or standing on one of its six sides, turned at random, none in the place of another. Drawn again until as much of
/// the wanted object is visible as was drawn, give or take 3 %, and all of it lies in the image; of 2000 tries the
/// nearest is taken. `meshes` by obj_id.
MadeScene made_scene(SceneWish const& wish, std::map<int, Mesh> const& meshes, Camera const& camera);

/// Writes a setting's scenes as a dataset in the format of BOP, whole or not at all: a scene per class, whose number is
/// the obj_id, of the setting's scene_meshes(). A folder that already holds these very scenes is left as it is.
/// `progress` is told how many images of all are done. Tells in how many the object is not as visible as was drawn.
/// Throws InputError if it cannot be written, Interrupted if somebody wants the program to end.
std::size_t make_dataset(std::filesystem::path const& folder, Setting const& setting, std::map<int, Mesh> meshes,
                         std::uint64_t seed, std::size_t jobs,
                         std::function<void(std::size_t done, std::size_t all)> const& progress);

}  // namespace faster::experiments
