#include "workload/object_size.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

namespace faster::workload {

double longest_side_m(Mesh const& mesh) {
    if (mesh.vertices.empty())
        return 0;
    Eigen::AlignedBox3d box;
    for (Eigen::Vector3d const& vertex : mesh.vertices)
        box.extend(vertex);
    return box.sizes().maxCoeff();
}

std::string size_warning(Mesh const& mesh, std::string const& file) {
    constexpr double suspicious_m = 10;
    double const side_m = longest_side_m(mesh);
    if (side_m < suspicious_m)
        return {};
    return fmt::format(
        "{}: is {:.4g} m long, which looks like millimetres; expected less than {} m "
        "(workload.mesh_files.scale: 0.001 reads millimetres)",
        file, side_m, suspicious_m);
}

}  // namespace faster::workload
