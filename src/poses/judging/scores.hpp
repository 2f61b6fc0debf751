#pragma once
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "poses/judging/judge.hpp"

namespace faster::poses {

/// An error [m], and how often it counts.
struct WeightedError {
    double error_m = 0;
    double weight = 1;
};

/// Area under the curve of accuracy (the share of instances with an error of at most x) over x from 0 to 0.1 m, of the
/// whole: 0..1. Exactly as the toolbox of YCB-Video has it (plot_accuracy_keyframe.m, VOCap): errors above 0.1 m are
/// infinite; sorted, the i-th of n stands at accuracy i / n; and from each error down to the one before, the curve has
/// the height of the *right* end. So n errors of 0.1 m make 1 / n and not 0.
/// `errors` ascend and are at most 0.1 m; `total` is the weight of all instances, those beyond 0.1 m included.
double area_under_accuracy(std::vector<WeightedError> const& errors, double total);

/// The plain area under the same curve, as a step function: the mean of 1 - error / 0.1 m over the instances. Errors
/// are at most 0.1 m; `total` is the weight of all instances.
double plain_area_under_accuracy(std::vector<WeightedError> const& errors, double total);

/// A score and what it is; all are percentages, and more is better.
struct ScoreFacts {
    char const* name;   ///< in files
    char const* title;  ///< in tables for people
    bool is_brief;      ///< stands on the terminal, where there is little room
    bool has_mean;      ///< the mean over objects says something
};
constexpr std::size_t score_count = 12;
/// The areas of the toolbox are 1 for a single instance, however far it is off, so there is no mean of them.
constexpr std::array<ScoreFacts, score_count> score_facts{{{"add_s_auc", "ADD-S AUC", true, false},
                                                           {"add_auc", "ADD AUC", true, false},
                                                           {"add_s_2cm", "ADD-S < 2 cm", true, true},
                                                           {"add_s_4cm", "ADD-S < 4 cm", false, true},
                                                           {"add_2cm", "ADD < 2 cm", false, true},
                                                           {"add_4cm", "ADD < 4 cm", false, true},
                                                           {"mssd_recall", "MSSD recall", false, true},
                                                           {"add_s_area", "ADD-S area", true, true},
                                                           {"add_area", "ADD area", true, true},
                                                           {"mspd_recall", "MSPD recall", false, true},
                                                           {"vsd_recall", "VSD recall", false, true},
                                                           {"ar", "AR", true, true}}};
using Scores = std::array<double, score_count>;

/// How often each image counts, by its number.
using ImageWeights = std::vector<double>;

/// Instances that are scored together: all of an object, or all.
class ScoredInstances {
  public:
    /// `image_numbers[i]` is the number of the image of instance i.
    ScoredInstances(std::vector<InstanceErrors> const& instances, std::vector<std::size_t> const& image_numbers);

    /// Their scores if each image counts as often as it says; NaN if no image with one of them counts, and for a recall
    /// that is not known of all of them. The toolbox's areas are the plain ones, and what the toolbox's are more than
    /// the plain ones if every image counts once: a draw has fewer different errors than there are images, so its own
    /// toolbox area would be too small.
    Scores scores(ImageWeights const& weights) const;

  private:
    struct Numbered {
        double error_m;
        std::size_t image;
    };
    struct Recall {
        double share;  ///< of the thresholds at which the instance counts as found; NaN if that is not known
        std::size_t image;
    };
    using Recalls = std::vector<Recall>;
    static std::vector<WeightedError> weighted(std::vector<Numbered> const& errors, ImageWeights const& weights);
    static double mean(Recalls const& recalls, ImageWeights const& weights, double total);
    double more_by_toolbox(std::vector<Numbered> const& errors) const;

    std::vector<Numbered> add_, add_s_;  // up to 0.1 m, ascending
    Recalls mssd_, mspd_, vsd_;
    double add_more_ = 0, add_s_more_ = 0;  // of the toolbox's area than of the plain one
};

}  // namespace faster::poses
