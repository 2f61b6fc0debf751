#pragma once
#include <vector>

#include "faster/data/camera.hpp"
#include "faster/data/fixed_point.hpp"
#include "faster/data/mesh.hpp"
#include "faster/data/tokens.hpp"

namespace faster::reference {

/// Brings one mesh into the image, pose after pose (docs/function.md#vertex-transform), keeping its buffers between
/// them. The mesh is held by reference; its faces must index into its vertices.
class VertexTransform {
  public:
    VertexTransform(Mesh const& mesh, Camera const& camera, FractionBits const& fraction);

    /// The triangles under `pose` in mesh order, one per face; valid until the next call. A triangle with a vertex
    /// outside 0.1 to 3.99 m, or one that its codes cannot hold, comes out with all vertices (-32768, -32768, 0).
    std::vector<TriangleCode> const& operator()(Pose const& pose);

  private:
    struct ImageVertex {
        VertexCode code;
        bool accepted = false;
    };

    ImageVertex project(Pose const& pose, Eigen::Vector3d const& vertex) const;

    Mesh const& mesh_;
    Camera camera_;
    double xy_codes_per_px_;  // powers of two, so that multiplying by them is exact
    double z_codes_per_m_;
    std::vector<ImageVertex> vertices_;
    std::vector<TriangleCode> triangles_;
};

}  // namespace faster::reference
