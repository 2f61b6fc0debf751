#pragma once
#include <string>
#include <vector>

#include "faster/data/mesh.hpp"

namespace faster::files {

constexpr double m_per_mm = 1e-3;

/// How far R^T R may be from the identity, in any entry: files keep six to eight digits.
constexpr double rotation_tolerance = 1e-3;

/// What a matrix would have to be to be a rotation, for a message; empty if it is one.
std::string rotation_problem(Eigen::Matrix3d const& rotation);

/// A matrix of nine numbers, row by row.
Eigen::Matrix3d matrix_of(std::vector<double> const& row_major);

/// Its nine numbers parted by blanks, with just the digits that bring back the same matrix.
std::string row_major_text(Eigen::Matrix3d const& matrix);

}  // namespace faster::files
