#include <algorithm>
#include <cstdint>
#include <fmt/format.h>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "dataflow/base/files/atomic_folder.hpp"
#include "dataflow/base/files/json_file.hpp"
#include "dataflow/base/files/text_file.hpp"
#include "dataflow/base/host_clock.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/base/on_threads.hpp"
#include "dataflow/commands/command_paths.hpp"
#include "dataflow/commands/exit_codes.hpp"
#include "dataflow/commands/options.hpp"
#include "dataflow/commands/progress_line.hpp"
#include "dataflow/commands/say.hpp"
#include "dataflow/commands/work_size.hpp"
#include "dataflow/run/config/choice_names.hpp"
#include "dataflow/run/config/config_sources.hpp"
#include "dataflow/run/config/load_config.hpp"
#include "faster/config/accelerator_config.hpp"
#include "faster/config/faster_config.hpp"
#include "faster/data/tokens.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/workload/object_pose.hpp"
#include "faster/workload/workload_source.hpp"
#include "modules/core/workload_iterations.hpp"
#include "poses/commands/estimate_scorers.hpp"
#include "poses/commands/estimate_size.hpp"
#include "poses/commands/pose_commands.hpp"
#include "poses/estimation/counter_scorer.hpp"
#include "poses/grip/rank_correlation.hpp"
#include "poses/grip/score_poses.hpp"
#include "poses/judging/pose_error.hpp"

namespace faster {

namespace {

/// `faster-sim grip`.
struct GripRequest {
    std::string config;
    std::vector<std::string> overrides;
    std::string out;        ///< folder for scores.csv and summary.json; empty: print only
    std::int64_t jobs = 0;  ///< threads; 0: the host's cores
    bool force = false;     ///< however long it takes, whatever memory there is
    double inlier_distance_m = 0.008;
};

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

using Values = std::vector<double>;

template <class Rows, class Figure> Values figures(Rows const& rows, Figure figure) {
    Values values;
    for (auto const& row : rows)
        values.push_back(static_cast<double>(figure(row)));
    return values;
}

/// Ratios of a flow's counters, and their mean: what GripComparison ranks its samples by.
double raw_ratio(SampleCounters const& counters) {
    return grip::InlierCount{counters.valid_raster, counters.inlier}.ratio();
}
double edge_ratio(SampleCounters const& counters) {
    return grip::InlierCount{counters.valid_edge, counters.edge_inlier}.ratio();
}
double weight(SampleCounters const& counters) { return (raw_ratio(counters) + edge_ratio(counters)) / 2; }

Values grip_weights(GripComparison const& comparison) {
    return figures(comparison.grip, [](grip::PoseScore const& score) { return score.weight(); });
}
Values flow_weights(GripComparison const& comparison) { return figures(comparison.counters, weight); }

/// A side's best sample.
struct Best {
    std::size_t sample;
    double add_mm;
};
Best best(GripComparison const& comparison, Values const& weights) {
    std::size_t const sample = grip::best_of(weights);
    return {sample, 1000 * comparison.add_m[sample]};
}

nlohmann::json best_json(GripComparison const& comparison, Values const& weights) {
    Best const found = best(comparison, weights);
    return {{"sample", found.sample}, {"add_mm", found.add_mm}};
}

std::vector<Agreement> agreements(GripComparison const& comparison) {
    auto const agreement = [&](char const* score, auto of_grip, auto of_flow) {
        return Agreement{
            score, grip::rank_correlation(figures(comparison.grip, of_grip), figures(comparison.counters, of_flow))};
    };
    using Score = grip::PoseScore;
    using Sums = SampleCounters;
    return {agreement(
                "weight", [](Score const& s) { return s.weight(); }, weight),
            agreement(
                "raw_ratio", [](Score const& s) { return s.raw.ratio(); }, raw_ratio),
            agreement(
                "edge_ratio", [](Score const& s) { return s.edge.ratio(); }, edge_ratio),
            agreement(
                "inliers", [](Score const& s) { return s.raw.inliers; }, [](Sums const& c) { return c.inlier; }),
            agreement(
                "edge_inliers", [](Score const& s) { return s.edge.inliers; },
                [](Sums const& c) { return c.edge_inlier; })};
}

std::string grip_text(GripComparison const& comparison) {
    std::string const design = design_name(comparison.flow, comparison.architecture);
    std::size_t const samples = comparison.grip.size();
    std::string text =
        fmt::format("{} samples by GRIP, untimed, on {} host {}: {:.2f} s, {:.2f} ms per sample\n", samples,
                    comparison.jobs, comparison.jobs == 1 ? "core" : "cores", comparison.grip_seconds,
                    1000 * comparison.grip_seconds / static_cast<double>(samples));
    text += fmt::format("\n  {:<12} {:>12} {:>14}\n", "ranked by", "best sample", "its ADD [mm]");
    for (auto const& [name, weights] :
         {std::pair{std::string("grip"), grip_weights(comparison)}, {design, flow_weights(comparison)}}) {
        Best const found = best(comparison, weights);
        text += fmt::format("  {:<12} {:>12} {:>14.2f}\n", name, found.sample, found.add_mm);
    }
    text += fmt::format("\n  {:<12} rank correlation of grip and {} (Spearman)\n", "score", design);
    for (Agreement const& row : agreements(comparison))
        text += row.rank_correlation ? fmt::format("  {:<12} {:.3f}\n", row.score, *row.rank_correlation)
                                     : fmt::format("  {:<12} -\n", row.score);
    return text;
}

std::string grip_csv(GripComparison const& comparison) {
    std::string text =
        "sample,grip_points,grip_inliers,grip_edges,grip_edge_inliers,grip_planars,grip_planar_inliers,grip_weight,"
        "grip_rank,valid_raster,inlier,valid_edge,edge_inlier,flow_weight,flow_rank,add_mm\n";
    Values const grip_ranks = grip::ranks(grip_weights(comparison));
    Values const flow_ranks = grip::ranks(flow_weights(comparison));
    for (std::size_t i = 0; i < comparison.grip.size(); ++i) {
        grip::PoseScore const& g = comparison.grip[i];
        SampleCounters const& c = comparison.counters[i];
        fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{:.6f},{},{},{},{},{},{:.6f},{},{:.3f}\n", i,
                       g.raw.points, g.raw.inliers, g.edge.points, g.edge.inliers, g.planar.points, g.planar.inliers,
                       g.weight(), grip_ranks[i], c.valid_raster, c.inlier, c.valid_edge, c.edge_inlier, weight(c),
                       flow_ranks[i], 1000 * comparison.add_m[i]);
    }
    return text;
}

std::string grip_json(GripComparison const& comparison) {
    nlohmann::json correlations = nlohmann::json::object();
    for (Agreement const& row : agreements(comparison))
        correlations[row.score] =
            row.rank_correlation ? nlohmann::json(*row.rank_correlation) : nlohmann::json(nullptr);
    nlohmann::json summary;
    summary["format"] = "faster-grip";
    summary["version"] = 1;
    summary["samples"] = comparison.grip.size();
    summary["architecture"] = comparison.architecture;
    summary["flow"] = choice_name(comparison.flow);
    summary["best"] = {{"grip", best_json(comparison, grip_weights(comparison))},
                       {"flow", best_json(comparison, flow_weights(comparison))}};
    summary["rank_correlation"] = std::move(correlations);
    summary["host"] = {{"jobs", comparison.jobs},
                       {"grip_seconds", comparison.grip_seconds},
                       {"reference_seconds", comparison.reference_seconds}};
    return io::text_of(summary, 2) + "\n";
}

io::FolderKind const grip_folder{"scores of the grip baseline", "summary.json", {"scores.csv"}, "faster-grip"};

/// A trace has triangles, but no poses to render.
void require_poses(LoadedConfig const& loaded) {
    if (!workload_of(loaded.config).trace.empty())
        throw InputError(complaint(loaded, "workload.trace", "none: grip renders poses, which a trace does not have"));
    if (workload_of(loaded.config).samples.count == 0)
        throw InputError(complaint(loaded, "workload.samples.count", "at least 1: grip compares samples"));
}

/// The untimed reference equals the model bit for bit.
std::vector<SampleCounters> flow_counters(AcceleratorConfig const& config, Stimulus const& stimulus) {
    reference::Scorer scorer = estimation::reference_scorer(stimulus, config);
    ProgressLine line("samples by the design");
    std::vector<SampleCounters> counters;
    for (std::size_t i = 0; i < stimulus.samples.size(); ++i) {
        counters.push_back(scorer.run(i));
        line.show(i + 1, stimulus.samples.size());
    }
    return counters;
}

std::vector<double> pose_errors(Stimulus const& stimulus, Pose const& target) {
    std::vector<double> errors;
    for (Pose const& pose : stimulus.posed.poses)
        errors.push_back(poses::add(stimulus.posed.mesh.vertices, pose, target));
    return errors;
}

std::vector<grip::PoseScore> scores_by_grip(Stimulus const& stimulus, grip::Settings const& settings, unsigned jobs) {
    ProgressLine line("samples by GRIP");
    return grip::score_poses(stimulus, settings, jobs, line.teller());
}

/// Both score all samples, one after the other.
WorkSize size_of(Stimulus const& stimulus, std::size_t jobs) {
    LoopIterations const iterations = loop_iterations(stimulus);
    WorkSize size;
    size.command = "grip";
    size.amount = fmt::format("{} samples, about {:.2g} loop iterations", stimulus.samples.size(), iterations.all());
    size.seconds = seconds_by_grip(stimulus, stimulus.samples.size()) / static_cast<double>(jobs) +
                   seconds_by_reference(iterations);
    return size;
}

GripComparison compare_with_flow(GripRequest const& request, RunConfig const& config, Stimulus const& stimulus) {
    GripComparison comparison;
    comparison.flow = accelerator_of(config).flow;
    comparison.architecture = accelerator_of(config).architecture;
    comparison.jobs = static_cast<unsigned>(jobs_or_host_cores(request.jobs));
    auto start = HostClock::now();
    comparison.grip =
        scores_by_grip(stimulus, grip_settings(workload_of(config), request.inlier_distance_m), comparison.jobs);
    comparison.grip_seconds = seconds_since(start);
    start = HostClock::now();
    comparison.counters = flow_counters(accelerator_of(config), stimulus);
    comparison.reference_seconds = seconds_since(start);
    comparison.add_m = pose_errors(stimulus, workload::configured_pose(workload_of(config).target));
    return comparison;
}

/// Scores a configuration's poses by the thesis's CPU + GPU baseline, and compares them with those of the configured
/// flow. Throws InputError on bad input.
int grip_baseline(GripRequest const& request) {
    LoadedConfig loaded = load_config(request.config, request.overrides);
    require_poses(loaded);
    CommandPaths paths;
    paths.reads(request.config);
    paths.reads(loaded.config);
    paths.writes("--out", request.out, grip_folder);
    std::unique_ptr<io::AtomicFolder> const folder =
        request.out.empty() ? nullptr : std::make_unique<io::AtomicFolder>(request.out, grip_folder);
    Stimulus const stimulus = load_stimulus(loaded);
    say_warnings(stimulus_warnings(stimulus, loaded));
    announce(size_of(stimulus, jobs_or_host_cores(request.jobs)), request.force);
    GripComparison const comparison = compare_with_flow(request, loaded.config, stimulus);
    if (folder != nullptr) {
        io::write_file(folder->path() / "scores.csv", grip_csv(comparison));
        io::write_file(folder->path() / "summary.json", grip_json(comparison));
        folder->commit();
    }
    say("{}", grip_text(comparison));
    say_written({request.out});
    return exit_done;
}

}  // namespace

Subcommand grip_command() {
    return {
        "grip",
        "Score the poses by the thesis's CPU and GPU baseline, untimed, and compare the ranking with the "
        "configured design's",
        [](CLI::App& command) {
            auto const request = std::make_shared<GripRequest>();
            command.add_option("config", request->config, "Configuration file (YAML)")->required()->type_name("CONFIG");
            command.add_option("--out", request->out, "Write scores.csv and summary.json to this folder")
                ->type_name("DIR");
            add_overrides(command, request->overrides);
            add_jobs(command, request->jobs, "Threads");
            add_force(command, request->force);
            command
                .add_option("--inlier-distance", request->inlier_distance_m, "Points closer than this agree (eq. 2.1)")
                ->type_name("METRES")
                ->capture_default_str()
                ->check(number_in(0.000001, 10));
            return [request] { return grip_baseline(*request); };
        }};
}

}  // namespace faster
