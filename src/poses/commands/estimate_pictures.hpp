#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "faster/config/accelerator_config.hpp"
#include "faster/data/image.hpp"
#include "faster/data/stimulus.hpp"
#include "faster/workload/pictures/colour.hpp"
#include "poses/commands/estimate_report.hpp"

namespace faster {

/// How an estimate went: weights, effective samples, spread and, if the truth is known, errors over the iterations.
Image<Colour> estimate_plots(std::vector<IterationRow> const& iterations);

/// What of an iteration is drawn.
struct DrawnIteration {
    std::uint64_t number = 0;
    std::string label;
    std::vector<Pose> poses;  ///< some samples
    Pose best;
};

/// Draws what the samples of an iteration look like in the scene, as thesis fig. 4.4: contours of some of them red,
/// observed edges blue, where both are purple, the best one's object green. All iterations show the same part of the
/// image, that around the estimate.
class EstimatePictures {
  public:
    /// `observed`: without samples. `shown`: in the middle of the pictures.
    EstimatePictures(Stimulus observed, AcceleratorConfig const& config, Pose const& shown);

    Image<Colour> picture(DrawnIteration const& iteration);

    /// images/iteration_NNNN.png and images/convergence.png, which has all of them side by side. `folder` is made.
    void write(std::filesystem::path const& folder, std::vector<DrawnIteration> const& iterations);

  private:
    /// Marks what a pose draws, in pixels of the shown part.
    void mark(Pose const& pose, Image<std::uint8_t>& contours, Image<std::uint8_t>* object);

    Stimulus stimulus_;
    AcceleratorConfig config_;
    std::int64_t top_ = 0;  ///< of the shown part, in the image; it may leave it
    std::int64_t left_ = 0;
    Image<std::uint8_t> observed_edges_;  ///< in the shown part
};

}  // namespace faster
