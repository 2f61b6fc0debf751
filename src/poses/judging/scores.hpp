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

/// The area of plain errors in any order, infinite ones among them.
double area_under_accuracy(std::vector<double> errors_m);

/// A score and what it is; all are percentages, and more is better.
struct ScoreFacts {
    char const* name;   ///< in files
    char const* title;  ///< in tables for people
    bool is_brief;      ///< stands on the terminal, where there is little room
};
constexpr std::size_t score_count = 7;
constexpr std::array<ScoreFacts, score_count> score_facts{{{"add_s_auc", "ADD-S AUC", true},
                                                           {"add_auc", "ADD AUC", true},
                                                           {"add_s_2cm", "ADD-S < 2 cm", true},
                                                           {"add_s_4cm", "ADD-S < 4 cm", false},
                                                           {"add_2cm", "ADD < 2 cm", false},
                                                           {"add_4cm", "ADD < 4 cm", false},
                                                           {"mssd_recall", "MSSD recall", true}}};
using Scores = std::array<double, score_count>;

/// How often each image counts, by its number.
using ImageWeights = std::vector<double>;

/// Instances that are scored together: all of an object, or all.
class ScoredInstances {
  public:
    /// `image_numbers[i]` is the number of the image of instance i.
    ScoredInstances(std::vector<InstanceErrors> const& instances, std::vector<std::size_t> const& image_numbers);

    /// Their scores if each image counts as often as it says; NaN if no image with one of them counts.
    Scores scores(ImageWeights const& weights) const;

  private:
    struct Numbered {
        double error_m;
        std::size_t image;
    };
    struct Hits {
        int hits;
        std::size_t image;
    };
    static std::vector<WeightedError> weighted(std::vector<Numbered> const& errors, ImageWeights const& weights);

    std::vector<Numbered> add_, add_s_;  // up to 0.1 m, ascending
    std::vector<Hits> mssd_;
};

}  // namespace faster::poses
