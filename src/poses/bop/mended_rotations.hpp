#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "faster/data/mesh.hpp"

namespace faster::bop {

/// Published poses are written with few digits, or composed of several: their matrices are a little off a rotation. The
/// nearest rotation is taken for those that are more than files::rotation_tolerance and at most
/// files::mendable_rotation off, and counted, to be told of once.
class MendedRotations {
  public:
    /// The rotation to work with. `problem` becomes what the matrix would have to be if it is too far off.
    Eigen::Matrix3d taken(Eigen::Matrix3d const& matrix, std::string& problem);

    /// A line about those of `place`, or none: "PLACE: 3 of 40 matrices R are up to 0.0094 off a rotation ...".
    void tell(std::string const& place, std::vector<std::string>& warnings) const;

  private:
    std::size_t read_ = 0;
    std::size_t mended_ = 0;
    double farthest_ = 0;
};

}  // namespace faster::bop
