#pragma once
#include <cstdint>
#include <vector>

#include "poses/estimation/scene.hpp"

namespace faster::estimation {

/// The loop's first samples (docs/poses.md#the-loop), each by a stream of its own, so that sample k does not depend on
/// how many there are:
///   box       one of the scene's, in proportion to the confidences
///   centre    in the box, columns and rows each by the mean of two uniform numbers: densest in its middle
///   depth     of a reading drawn in the same way, plus between half the least extent and half the diameter of the
///             object, as a reading lies on its front. Drawn again if there is none, or if the object would be so far
///             away that it could not fill two thirds of the box's longer side. Without success: where it just fills
///             that side
///   rotation  uniform on SO(3)
std::vector<Particle> first_samples(Scene const& scene, std::size_t count, std::uint64_t seed);

}  // namespace faster::estimation
