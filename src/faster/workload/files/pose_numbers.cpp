#include "faster/workload/files/pose_numbers.hpp"

#include <Eigen/LU>
#include <fmt/format.h>

namespace faster::files {

std::string rotation_problem(Eigen::Matrix3d const& rotation) {
    double const error = (rotation.transpose() * rotation - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
    if (!(error <= rotation_tolerance))
        return fmt::format("a rotation (R^T R differs from the identity by {:.3g}, at most {})", error,
                           rotation_tolerance);
    return rotation.determinant() > 0 ? "" : "a rotation (this one mirrors: its determinant is -1)";
}

Eigen::Matrix3d matrix_of(std::vector<double> const& row_major) {
    return Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor> const>(row_major.data());
}

std::string row_major_text(Eigen::Matrix3d const& matrix) {
    Eigen::Matrix<double, 3, 3, Eigen::RowMajor> const rows = matrix;
    return fmt::format("{}", fmt::join(rows.data(), rows.data() + rows.size(), " "));
}

}  // namespace faster::files
