#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "dataflow/base/files/atomic_folder.hpp"
#include "dataflow/commands/recording_options.hpp"
#include "dataflow/commands/work_size.hpp"
#include "dataflow/run/config/load_config.hpp"
#include "faster/dataflow_names.hpp"
#include "poses/bop/pose_results.hpp"
#include "poses/commands/estimate_report.hpp"
#include "poses/commands/estimate_scene.hpp"
#include "poses/commands/timed_iterations.hpp"
#include "poses/estimation/estimator.hpp"

namespace faster {

/// `faster-sim estimate`.
struct EstimateRequest {
    std::string config;
    std::vector<std::string> overrides;
    std::string out;                                  ///< folder; empty: print only
    std::string backend;                              ///< stands for estimator.backend; empty: as configured
    std::vector<std::uint64_t> pictures;              ///< iterations to draw; empty: a choice of them
    std::vector<std::uint64_t> traces;                ///< iterations to write as stimulus traces
    std::int64_t jobs = 0;                            ///< threads and processes; 0: the host's cores
    BopRequest bop;                                   ///< instead of the configured workload
    bool all = false;                                 ///< every target of the dataset
    bool untimed = false;                             ///< without the accelerator's cycles
    std::optional<std::uint64_t> recorded_iteration;  ///< the first unless told otherwise
    std::string events;                               ///< file of that iteration's events; empty: none
    RecordingRequest recording;                       ///< of that iteration
    bool force = false;                               ///< however long it takes, and even a waveform of more than 2 GB

    bool records() const { return !events.empty() || recording.has_waveform() || !recording.timeline.empty(); }
};

/// The loop, and all that is kept of it.
class EstimateRun {
  public:
    EstimateRun(EstimateRequest const& request, LoadedConfig const& loaded);
    /// Of a configured scene: a dataset says its units itself.
    std::vector<std::string> warnings() const;
    WorkSize size() const;
    void find_pose();
    void find_times(io::AtomicFolder* folder);
    EstimateReport report() const;
    void write(std::filesystem::path const& folder, EstimateReport const& report) const;

  private:
    /// Empty if something tells where the object is.
    std::string unset_place_warning() const;
    bool is_timed() const;
    /// One host core need not score without time first: several simulate iterations of which the scores are known.
    bool simulates_at_once() const { return is_timed() && jobs_ == 1 && !request_.records(); }
    /// Of no iteration, so it is not simulated; empty: it is scored as the samples are.
    estimation::Score score_of_mean();
    /// Nothing if there is nothing to record. What is to be in the folder in the end is written to its place there.
    std::optional<IterationRecording> recorded_iteration(io::AtomicFolder* folder) const;
    void add_refinement(EstimateReport& report) const;
    void set_cost(IterationRow& row, IterationCost const& cost);
    bop::PoseEstimate bop_estimate(EstimateReport const& report) const;
    void write_pictures(std::filesystem::path const& folder) const;

    EstimateRequest const& request_;
    LoadedConfig const& loaded_;
    std::size_t jobs_;
    estimation::Scene scene_;
    estimation::Estimate estimate_;
    Pose pose_;                       ///< of the frame of the scene's mesh, refined
    std::optional<Estimate> idle_w_;  ///< while the accelerator waits, if it was simulated
    std::vector<IterationRow> rows_;
    std::vector<ScoredPoses> scored_;
};

}  // namespace faster
