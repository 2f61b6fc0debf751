#pragma once
#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "poses/bop/dataset.hpp"
#include "poses/bop/pose_results.hpp"

namespace faster::poses {

// Which estimates and true poses count for a target.

using Estimates = std::vector<bop::PoseEstimate const*>;
using Truths = std::vector<bop::GroundTruth const*>;

/// Estimates by target, the best score first; of equal scores the one that stands first.
class EstimatesByTarget {
  public:
    /// Of estimates from `file`. Errors: InputError, naming file and line, if none of them is of a target, and for one
    /// of a target that is no pose.
    EstimatesByTarget(bop::Dataset const& dataset, std::vector<bop::PoseEstimate> const& estimates,
                      std::filesystem::path const& file, std::vector<std::string>& warnings);

    /// The inst_count best.
    Estimates best(bop::Target const& target) const;
    /// Warns if half of the estimates are a hundred times as near as half of the true poses are, or as far.
    void tell_of_unit(std::vector<std::string>& warnings) const;

  private:
    using TargetName = std::pair<bop::ImageId, int>;

    void sort_in(bop::PoseEstimate const& estimate);
    void require_some(std::vector<bop::PoseEstimate> const& estimates) const;
    void tell(std::size_t rows, std::vector<std::string>& warnings) const;

    bop::Dataset const& dataset_;
    std::filesystem::path const& file_;
    std::map<TargetName, Estimates> groups_;
    std::size_t taken_ = 0, unknown_ = 0;
    std::string first_unknown_;
};

/// The inst_count most visible true poses of a target, or as many as there are. One of which nobody says how much is
/// visible counts as all visible; of equals the one that stands first.
Truths most_visible(bop::Dataset const& dataset, bop::Target const& target);

/// Warns if targets ask for more than has been annotated.
void tell_of_missing_truths(bop::Dataset const& dataset, std::vector<std::string>& warnings);

}  // namespace faster::poses
