#pragma once
#include <cstdint>

#include "faster/config/workload_config.hpp"
#include "faster/workload/depth_image.hpp"

namespace faster::workload {

/// What a structured-light depth sensor makes of a perfect depth image: axial noise
///   sigma_z = axial_base + axial_quadratic * (z - axial_offset)^2,
/// and missing readings, at random and at depth edges (a neighbour above, below, left or right that is farther away or
/// nearer than edge_step_m, or nothing). The same seed gives the same image; a pixel's draws do not depend on the
/// others. Left out: lateral noise, quantisation of the disparity, shadow of the projector. Source: Nguyen, Izadi,
/// Lovell, 3DIMPVT 2012, eq. 1 (without the term for grazing angles).
void add_sensor_noise(DepthImage& depth, NoiseConfig const& config, std::uint64_t seed);

}  // namespace faster::workload
