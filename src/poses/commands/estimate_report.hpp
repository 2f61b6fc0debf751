#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "dataflow/run/config/resolved_config.hpp"
#include "dataflow/tools/resources/path_table.hpp"
#include "faster/config/estimator_config.hpp"
#include "faster/data/mesh.hpp"
#include "faster/dataflow_names.hpp"

namespace faster {

/// Distances of a pose from the truth [m] (docs/poses.md#errors).
struct PoseDistances {
    double add_m = 0;
    double adds_m = 0;
};

/// What is told of an iteration.
struct IterationRow {
    std::uint64_t number = 0;  ///< over all runs
    std::uint64_t run = 0;
    std::size_t best_sample = 0;
    double best_weight = 0;
    double mean_weight = 0;
    double effective_samples = 0;
    double spread_mm = 0;
    double spread_deg = 0;
    double translation_sigma_mm = 0;  ///< of the noise that made its samples
    double rotation_sigma_deg = 0;
    std::optional<PoseDistances> best;    ///< of the best sample, if the truth is known
    std::optional<std::uint64_t> cycles;  ///< of the accelerator, if it was simulated
    std::optional<double> accelerator_ms;
    std::optional<double> iteration_ms;  ///< with the host's part
    std::optional<Estimate> energy_mj;   ///< the same
};

/// How an estimate ended.
enum class Verdict {
    found,
    weak,         ///< less weight than estimator.least_weight
    no_readings,  ///< the depth camera saw nothing in the box
};

/// All that an estimate has to tell.
struct EstimateReport {
    std::string object;
    std::string scorer;  ///< the preset, the flow, or grip
    std::uint64_t samples = 0;
    std::uint64_t seed = 0;
    std::vector<DetectionConfig> boxes;
    Pose pose;
    double weight = 0;
    std::uint64_t runs = 1;
    std::uint64_t run = 0;       ///< that is kept
    bool stopped_early = false;  ///< by stop_weight
    Verdict verdict = Verdict::found;
    std::optional<Pose> truth;
    std::optional<PoseDistances> distances;
    std::vector<IterationRow> iterations;
    HostConfig host;
    double refine_ms = 0;               ///< of the host; 0: not refined
    std::optional<Estimate> refine_mj;  ///< while it does that, if times are known
    std::vector<ResolvedKey> keys;

    std::optional<double> total_ms() const;  ///< if all iterations have a time
    std::optional<Estimate> total_mj() const;
};

/// For people.
std::string estimate_text(EstimateReport const& report);
/// A row per iteration; a figure that is not known is an empty cell.
std::string estimate_csv(EstimateReport const& report);
std::string estimate_json(EstimateReport const& report);

}  // namespace faster
