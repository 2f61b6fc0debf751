#include "faster/workload/models/primitives/compose.hpp"

#include <Eigen/Geometry>
#include <cstdint>

#include "dataflow/base/portable_math.hpp"
#include "faster/data/mesh_size.hpp"

namespace faster::models {

Mesh joined(std::vector<Mesh> const& parts) {
    Mesh whole;
    for (Mesh const& part : parts) {
        auto const offset = static_cast<std::uint32_t>(whole.vertices.size());
        whole.vertices.insert(whole.vertices.end(), part.vertices.begin(), part.vertices.end());
        for (auto const& face : part.faces) {
            whole.faces.push_back({face[0] + offset, face[1] + offset, face[2] + offset});
        }
    }
    return whole;
}

Mesh turned_about_z(Mesh mesh, double degrees) {
    constexpr double radians_per_degree = dataflow::portable::pi / 180.0;
    Eigen::AngleAxisd const turn(degrees * radians_per_degree, Eigen::Vector3d::UnitZ());
    Eigen::Matrix3d const rotation = turn.toRotationMatrix();
    for (Eigen::Vector3d& vertex : mesh.vertices) {
        vertex = (rotation * vertex).eval();
    }
    return mesh;
}

Mesh fitted(Mesh mesh, Eigen::Vector3d const& size) {
    Eigen::AlignedBox3d const bounds = box_of(mesh);
    Eigen::Vector3d const centre = bounds.center();
    Eigen::Vector3d const scale = size.cwiseQuotient(bounds.sizes());
    for (Eigen::Vector3d& vertex : mesh.vertices) {
        vertex = scale.cwiseProduct(vertex - centre).eval();
    }
    return mesh;
}

}  // namespace faster::models
