#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "faster/data/camera.hpp"

namespace faster {

/// One object of a rendered scene; an item of the list `workload.scene.objects`.
struct SceneObjectConfig {
    std::string object = "cracker_box";               ///< built-in class, or a mesh file (obj, ply, stl, off)
    std::array<double, 3> translation_m{0, 0, 0.65};  ///< object origin in the camera frame
    std::array<double, 3> rotation_deg{0, 0, 0};      ///< about the camera's x, then y, then z axis (R = Rz Ry Rx)
};

/// Depth-sensor noise of a rendered scene; `workload.scene.noise.*`. Model: Nguyen, Izadi, Lovell, "Modeling Kinect
/// Sensor Noise for Improved 3D Reconstruction and Tracking", 3DIMPVT 2012.
struct NoiseConfig {
    bool enabled = true;
    double axial_base_m = 0.0012;     ///< standard deviation at `axial_offset_m`
    double axial_quadratic = 0.0019;  ///< [1/m], times (z - axial_offset_m)^2
    double axial_offset_m = 0.4;
    double edge_dropout = 0.5;      ///< probability of a missing reading at a depth edge
    double edge_step_m = 0.03;      ///< depth difference of neighbours that makes a depth edge
    double random_dropout = 0.002;  ///< probability of a missing reading anywhere
};

/// The observed scene; `workload.scene.*`: a depth image, or objects to render.
struct SceneConfig {
    std::string depth_image;       ///< 16-bit PNG; empty: render
    double depth_unit_m = 0.001;   ///< metres per unit of depth_image
    int downscale = 1;             ///< integer, keeps every n-th pixel of the depth image and divides the camera by it
    bool table = true;             ///< table plane below the object, when rendering
    double table_height_m = 0.11;  ///< camera y of the table at the object's distance
    double table_tilt_deg = 30;    ///< the camera looks down on the table by this angle
    std::vector<SceneObjectConfig> objects;  ///< other objects of the scene (clutter, occluders)
    NoiseConfig noise;
    std::uint64_t seed = 1;
};

/// Observed edges by thesis eq. 2.2; `workload.observed_edges.*`.
struct ObservedEdgesConfig {
    int neighbourhood = 5;    ///< side n of the n x n neighbourhood [px], odd, >= 3
    double threshold = 0.01;  ///< c(u, v) above it is an edge
};

/// The pose samples; `workload.samples.*`.
struct SamplesConfig {
    std::uint64_t count = 620;          ///< thesis 4.2.1
    double translation_sigma_m = 0.01;  ///< normal spread around the ground truth, per axis
    double rotation_sigma_deg = 5;      ///< normal spread of the rotation angle about a random axis
    std::uint64_t seed = 2;
    std::string poses;  ///< table of poses, which replaces all the above; empty: draw them
};

/// How mesh files are read, and what that may take; `workload.mesh_files.*`.
struct MeshFilesConfig {
    double time_limit_s = 10;
    std::uint64_t memory_limit_mib = 1024;
    std::uint64_t file_limit_mib = 256;
    double scale = 1;  ///< metres per unit
};

/// What the machine works on; keys `workload.*`.
struct WorkloadConfig {
    SceneObjectConfig target;            ///< workload.object, .pose.translation_m, .pose.rotation_deg
    std::uint64_t max_triangles = 1200;  ///< simplify the mesh to this many; 0: as it is
    Camera camera;                       ///< workload.camera.*
    SceneConfig scene;
    ObservedEdgesConfig observed_edges;
    SamplesConfig samples;
    MeshFilesConfig mesh_files;
    std::string trace;  ///< folder of a stimulus trace; replaces all the above
};

}  // namespace faster
