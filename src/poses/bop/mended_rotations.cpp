#include "poses/bop/mended_rotations.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "faster/workload/files/pose_numbers.hpp"

namespace faster::bop {

Eigen::Matrix3d MendedRotations::taken(Eigen::Matrix3d const& matrix, std::string& problem) {
    problem = files::rotation_problem(matrix, files::mendable_rotation);
    if (!problem.empty())
        return matrix;
    ++read_;
    double const off = files::distance_from_rotation(matrix);
    if (off <= files::rotation_tolerance)
        return matrix;
    ++mended_;
    farthest_ = std::max(farthest_, off);
    return files::nearest_rotation(matrix);
}

void MendedRotations::tell(std::string const& place, std::vector<std::string>& warnings) const {
    if (mended_ > 0)
        warnings.push_back(
            fmt::format("{}: {} of {} matrices R are up to {:.3g} off a rotation (R^T R from the identity, at most {} "
                        "is rounding): "
                        "the nearest rotations are taken",
                        place, mended_, read_, farthest_, files::rotation_tolerance));
}

}  // namespace faster::bop
