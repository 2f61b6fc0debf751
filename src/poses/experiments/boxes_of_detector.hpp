#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "poses/bop/detections.hpp"
#include "poses/experiments/experiment_file.hpp"

namespace faster::experiments {

/// The boxes in which a first stage would see an instance of a target, by the model of docs/poses.md: at most the right
/// one, shifted and scaled, and a wrong one around another object of the image. `instance`: its number, from 0;
/// `truth`: its annotated box; `others`: those of other objects. The same seed, target and instance, the same boxes.
std::vector<bop::Detection> boxes_of_detector(bop::Target const& target, std::size_t instance,
                                              bop::ImageBox const& truth, std::vector<bop::ImageBox> const& others,
                                              DetectorModel const& model, std::uint64_t seed);

}  // namespace faster::experiments
