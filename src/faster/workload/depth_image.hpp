#pragma once
#include <cstdint>
#include <filesystem>

#include "faster/data/camera.hpp"
#include "faster/data/image.hpp"
#include "faster/data/mesh.hpp"

namespace faster::workload {

/// Distances along z [m], 0 = nothing there or no reading.
using DepthImage = Image<double>;

/// The camera of an image of which only every n-th row and column is kept, starting with 0.
Camera downscaled(Camera const& camera, int n);

/// Those rows and columns of an image.
DepthImage downscaled(DepthImage const& depth, int n);

/// Reads a 16-bit PNG or TIFF of the camera's size and keeps every `downscale`-th row and column. Throws InputError.
DepthImage load_depth_image(std::filesystem::path const& path, double unit_m, Camera const& camera, int downscale);

/// Depth as the machine gets it: truncated to u11 with `fraction_bits` after the point, beyond that far; 0 stays 0.
Image<std::uint16_t> depth_codes(DepthImage const& depth, int fraction_bits);

}  // namespace faster::workload
