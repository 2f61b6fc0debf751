#pragma once
#include <cstdint>

#include "config/workload_config.hpp"
#include "workload/depth_image.hpp"

namespace faster::workload {

/// Edges of the observed scene, 0 or 1 per pixel: thesis eq. 2.2,
///   c = || sum over N of (p' - p) || / (|N| * ||p||) > threshold,
/// on the points p the pixels see (camera frame). N: the pixels of the n x n square around p, without p, that lie in
/// the image and have a reading. Others are skipped, so a missing reading is not an edge by itself, nor is the image
/// border; what remains lopsided there moves the mean of a plane by less than n/4 pixels, far below any useful
/// threshold. A pixel without reading, or without any neighbour, is no edge.
Image<std::uint8_t> observed_edges(DepthImage const& depth, Camera const& camera, ObservedEdgesConfig const& config);

}  // namespace faster::workload
