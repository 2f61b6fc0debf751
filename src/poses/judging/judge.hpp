#pragma once
#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "poses/bop/dataset.hpp"
#include "poses/bop/pose_results.hpp"

namespace faster::poses {

constexpr double largest_add_m = 0.1;  ///< ADD and ADD-S beyond are failures
constexpr int recall_thresholds = 10;  ///< MSSD: 0.05, 0.10, ... 0.50 of the diameter; MSPD: 5, 10, ... 50 px

/// An instance of an object that was to be found, and how far the estimate is off; infinity where there is none.
struct InstanceErrors {
    bop::ImageId image;
    int obj_id = 0;
    std::optional<double> visible_share;
    double add_m = 0;
    double add_s_m = 0;
    double mssd_m = 0;
    int mssd_hits = 0;   ///< at how many of the thresholds it counts as found
    double mspd_px = 0;  ///< of an image of 640 pixels' width
    int mspd_hits = 0;
    std::optional<double> vsd_recall = {};  ///< share of tolerances and thresholds; not known without a depth image
};

/// How far an estimate that counts is off, each from the nearest of the true poses that count.
struct EstimateErrors {
    std::size_t line = 0;  ///< of the estimate's file
    double add_m = 0;
    double add_s_m = 0;
    double mssd_m = 0;
};

struct JudgeOptions {
    std::size_t jobs = 1;        ///< threads; the result does not depend on them
    double vsd_delta_m = 0.015;  ///< of VSD; BOP has 5 mm for ITODD
};

struct Judgement {
    std::vector<InstanceErrors> instances;  ///< in the order of the targets
    std::vector<EstimateErrors> estimates;  ///< of targets with a true pose, in their order
    std::size_t left_out = 0;               ///< estimates of an object that is no target in their image, or too many
    std::vector<std::string> warnings;      ///< what looks like a mistake of the dataset or the estimates
};

/// Compares estimates with the dataset's targets, as BOP does: of each target's estimates, only the inst_count best by
/// score count, and of its true poses the inst_count most visible ones, or as many as there are. `progress` is told how
/// many targets are done. Throws InputError naming `file` and line: a matrix of a target's estimate that is no
/// rotation; and if no estimate is of a target.
Judgement judge(bop::Dataset const& dataset, std::vector<bop::PoseEstimate> const& estimates,
                std::filesystem::path const& file, JudgeOptions const& options,
                std::function<void(std::size_t done, std::size_t all)> const& progress = {});

}  // namespace faster::poses
