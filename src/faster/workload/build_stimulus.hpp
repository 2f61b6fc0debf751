#pragma once
#include "faster/config/workload_config.hpp"
#include "faster/data/stimulus.hpp"
#include "faster/workload/depth_image.hpp"

namespace faster::workload {

/// Makes the work of a run from its description: the object's mesh, the observed scene (rendered, or a depth image),
/// its edges, and the pose samples, drawn or of a table. The result is posed: the vertex transform is still to be done.
/// `config.trace` is not looked at. Throws InputError naming the key or file.
Stimulus build_stimulus(WorkloadConfig const& config, int window, FractionBits const& fraction);

/// What is observed, without samples: mesh, scene and edges.
Stimulus build_observation(WorkloadConfig const& config, int window, FractionBits const& fraction);

/// What is observed, of a depth image at hand: of the workload, only the limit of triangles and the edges' keys matter.
Stimulus observed_stimulus(Mesh const& mesh, DepthImage const& depth, Camera const& camera,
                           WorkloadConfig const& config, int window, FractionBits const& fraction);

/// Replaces the samples of what build_observation() made. Throws InputError if a pose has its origin nearer than 0.1 m.
/// `table`: the file that the poses are the rows of; empty if they were drawn.
void set_poses(std::vector<Pose> poses, Stimulus& stimulus, std::string const& table = {});

}  // namespace faster::workload
