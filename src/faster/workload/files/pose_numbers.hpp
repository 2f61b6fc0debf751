#pragma once
#include <string>
#include <vector>

#include "faster/data/mesh.hpp"

namespace faster::files {

constexpr double m_per_mm = 1e-3;

/// How far R^T R may be from the identity, in any entry: files keep six to eight digits.
constexpr double rotation_tolerance = 1e-3;

/// What a matrix would have to be to be a rotation, for a message; empty if it is one, or at most `tolerance` away.
std::string rotation_problem(Eigen::Matrix3d const& rotation, double tolerance = rotation_tolerance);

/// How far a matrix of published poses may be from a rotation; true poses of LM-O are 0.0094 off.
constexpr double mendable_rotation = 0.02;

/// How far R^T R is from the identity, in the entry where it is most; infinite if that is no number.
double distance_from_rotation(Eigen::Matrix3d const& matrix);

/// The rotation that differs least from a matrix (by the sum of squares of its entries).
Eigen::Matrix3d nearest_rotation(Eigen::Matrix3d const& matrix);

/// A matrix of nine numbers, row by row.
Eigen::Matrix3d matrix_of(std::vector<double> const& row_major);

/// Its nine numbers parted by blanks, with just the digits that bring back the same matrix.
std::string row_major_text(Eigen::Matrix3d const& matrix);

}  // namespace faster::files
