#pragma once
#include <array>
#include <cstddef>

#include "faster/data/camera.hpp"
#include "faster/data/image.hpp"
#include "faster/data/mesh.hpp"
#include "poses/bop/read_dataset.hpp"

namespace faster::poses {

/// An image of distances from the camera's centre [m]: a part of the whole image, 0 where there is nothing.
struct DistanceImage {
    int top = 0;
    int left = 0;
    Image<double> distances;

    double at(int row, int col) const {
        return distances.contains(row - top, col - left) ? distances.at(row - top, col - left) : 0;
    }
};

/// What the depth camera saw.
DistanceImage seen_distances(bop::Observation const& observation);

/// An object alone, as grip::render() draws it: triangles with a corner nearer than 1 cm are left out.
DistanceImage drawn_distances(Mesh const& mesh, Pose const& pose, Camera const& camera);

constexpr std::size_t vsd_tolerances = 10;  ///< 0.05, 0.10, ... 0.50 of the diameter

/// VSD (Hodan et al., ECCV 2018, "step"; visibility as of BOP 2019: where the camera has no reading, what is drawn is
/// taken for visible) for each of the tolerances: of the pixels in which the object is visible in one of its poses, the
/// share in which it is not in both, or as much as the tolerance nearer in one than in the other. 1 if there are none.
/// `delta_m`: how far behind a reading a pixel still counts as visible.
std::array<double, vsd_tolerances> vsd(DistanceImage const& seen, DistanceImage const& estimate,
                                       DistanceImage const& truth, double delta_m, double diameter_m);

}  // namespace faster::poses
