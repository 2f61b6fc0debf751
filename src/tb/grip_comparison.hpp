#pragma once
#include <optional>
#include <string>
#include <vector>

#include "common/tokens.hpp"
#include "faster/accelerator_config.hpp"
#include "reference/grip/score_poses.hpp"

namespace faster {

/// The scores of the same samples by GRIP and by a flow of the accelerator, how far their poses are off, and host time.
struct GripComparison {
    Flow flow = Flow::faster;
    std::string architecture;  ///< name of the preset that the design started from
    std::vector<grip::PoseScore> grip;
    std::vector<SampleCounters> counters;
    std::vector<double> add_m;  ///< average distance from the configured pose
    unsigned jobs = 1;
    double grip_seconds = 0;
    double reference_seconds = 0;  ///< for the flow's counters, on one core
};

/// How two scores order the samples.
struct Agreement {
    char const* score;
    std::optional<double> rank_correlation;  ///< Spearman's; nothing if one side scores all samples alike
};
std::vector<Agreement> agreements(GripComparison const& comparison);

/// Ratios of a flow's counters, and their mean: what GripComparison ranks its samples by.
double raw_ratio(SampleCounters const& counters);
double edge_ratio(SampleCounters const& counters);
double weight(SampleCounters const& counters);

std::string grip_text(GripComparison const& comparison);
std::string grip_csv(GripComparison const& comparison);
std::string grip_json(GripComparison const& comparison);

}  // namespace faster
