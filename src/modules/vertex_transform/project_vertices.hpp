#pragma once
#include <vector>

#include "faster/data/camera.hpp"
#include "faster/data/stimulus.hpp"

namespace faster::datapath {

/// A vertex in the rasterizer's formats, and whether it got there (docs/function.md#vertex-transform).
struct ProjectedVertex {
    VertexCode code;
    bool usable = false;  ///< depth within [0.1, 3.99] m and every code within its width
};

/// Projects one point of the object frame [m]; double arithmetic in the order of docs/function.md, truncated to the
/// formats.
ProjectedVertex project(Eigen::Vector3d const& point, Pose const& pose, Camera const& camera, FractionBits const& bits);

/// The whole mesh under a pose, as the triangle stream of one sample: `triangles` is overwritten, in face order.
class VertexTransformer {
  public:
    VertexTransformer(PosedMesh const& posed, FractionBits const& bits) : posed_(posed), bits_(bits) {}
    void transform(std::size_t sample, std::vector<TriangleCode>& triangles);

  private:
    PosedMesh const& posed_;
    FractionBits bits_;
    std::vector<ProjectedVertex> vertices_;
};

}  // namespace faster::datapath
