#pragma once
#include <string>
#include <vector>

#include "faster/config/workload_config.hpp"
#include "faster/data/camera.hpp"
#include "faster/data/fixed_point.hpp"
#include "faster/data/mesh.hpp"
#include "faster/workload/depth_image.hpp"

namespace faster::workload {

// What in the inputs of a workload looks like another unit, sign or direction than was meant: sentences for people,
// with what was measured and the key that mends it. They are guesses; nothing is changed or refused.

/// Of the mesh of a mesh file: its size, and whether its faces are turned inwards.
std::vector<std::string> mesh_warnings(Mesh const& mesh, std::string const& file);

/// Of the keys workload.camera.*.
std::vector<std::string> camera_warnings(Camera const& camera);

/// Of a depth image whose unit is `unit_key` (with its value): whether its readings are where a sensor of 3 m has them.
/// Empty if they are.
std::string depth_range_warning(DepthImage const& depth, std::string const& file, std::string const& unit_key);

/// Whether a depth image has readings at the distance of the object anywhere where the poses put it. Empty if it has,
/// or has no readings there at all.
std::string depth_pose_warning(DepthImage const& depth, Camera const& camera, Mesh const& mesh,
                               std::vector<Pose> const& poses, std::string const& file, std::string const& unit_key);

/// All of a workload that is no trace, whose object is `mesh`, to be seen under `poses`. Reads its depth image.
std::vector<std::string> input_warnings(WorkloadConfig const& config, Mesh const& mesh, std::vector<Pose> const& poses,
                                        FractionBits const& fraction);

}  // namespace faster::workload
