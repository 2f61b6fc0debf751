#include "faster/workload/files/pose_numbers.hpp"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace faster::files {

std::string rotation_problem(Eigen::Matrix3d const& rotation, double tolerance) {
    double const error = distance_from_rotation(rotation);
    if (!(error <= tolerance))
        return fmt::format("a rotation (R^T R differs from the identity by {:.3g}, at most {})", error, tolerance);
    return rotation.determinant() > 0 ? "" : "a rotation (this one mirrors: its determinant is -1)";
}

double distance_from_rotation(Eigen::Matrix3d const& matrix) {
    double const error = (matrix.transpose() * matrix - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
    return std::isfinite(error) ? error : std::numeric_limits<double>::infinity();
}

Eigen::Matrix3d nearest_rotation(Eigen::Matrix3d const& matrix) {
    Eigen::JacobiSVD<Eigen::Matrix3d> const parts(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Eigen::Vector3d signs = Eigen::Vector3d::Ones();
    signs(2) = (parts.matrixU() * parts.matrixV().transpose()).determinant() < 0 ? -1 : 1;
    return parts.matrixU() * signs.asDiagonal() * parts.matrixV().transpose();
}

Eigen::Matrix3d matrix_of(std::vector<double> const& row_major) {
    return Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor> const>(row_major.data());
}

std::string row_major_text(Eigen::Matrix3d const& matrix) {
    Eigen::Matrix<double, 3, 3, Eigen::RowMajor> const rows = matrix;
    return fmt::format("{}", fmt::join(rows.data(), rows.data() + rows.size(), " "));
}

}  // namespace faster::files
