#pragma once
#include <cstdint>

#include "faster/config/workload_config.hpp"
#include "faster/data/camera.hpp"
#include "faster/workload/depth_image.hpp"

namespace faster::workload {

/// Edges of the observed scene, 0 or 1 per pixel: thesis eq. 2.2,
///   c = || sum over N of (p' - p) || / (|N| * ||p||) > threshold,
/// on the points p the pixels see (camera frame). N: the pixels of the n x n square around p, without p, that lie in
/// the image and have a reading. Others are skipped, so neither a missing reading nor the image border is an edge by
/// itself. What remains lopsided there shifts the mean of a wall by up to n/4 pixels, so c = n / (4 * f): 0.002 by
/// default, but choose the threshold with care for a downscaled, wide camera. A pixel without reading or neighbour is
/// no edge.
Image<std::uint8_t> observed_edges(DepthImage const& depth, Camera const& camera, ObservedEdgesConfig const& config);

}  // namespace faster::workload
