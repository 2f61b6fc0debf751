#include "tb/grip_command.hpp"

#include <algorithm>
#include <chrono>
#include <fmt/format.h>
#include <memory>

#include "faster/faster_config.hpp"
#include "kernel/base/files/atomic_folder.hpp"
#include "kernel/base/files/text_file.hpp"
#include "kernel/base/input_error.hpp"
#include "kernel/base/on_threads.hpp"
#include "kernel/config/config_sources.hpp"
#include "kernel/config/load_config.hpp"
#include "poses/pose_error.hpp"
#include "reference/scorer.hpp"
#include "tb/estimate_size.hpp"
#include "tb/grip_comparison.hpp"
#include "tb/workload_iterations.hpp"
#include "tb/workload_source.hpp"
#include "tool/command_paths.hpp"
#include "tool/exit_codes.hpp"
#include "tool/options.hpp"
#include "tool/progress_line.hpp"
#include "tool/say.hpp"
#include "tool/work_size.hpp"
#include "workload/object_pose.hpp"

namespace faster {

namespace {

using HostClock = std::chrono::steady_clock;

io::FolderKind const grip_folder{"scores of the grip baseline", "scores.csv", {"summary.json"}};

double seconds_since(HostClock::time_point start) {
    return std::chrono::duration<double>(HostClock::now() - start).count();
}

/// A trace has triangles, but no poses to render.
void require_poses(LoadedConfig const& loaded) {
    if (!workload_of(loaded.config).trace.empty())
        throw InputError(complaint(loaded, "workload.trace", "none: grip renders poses, which a trace does not have"));
    if (workload_of(loaded.config).samples.count == 0)
        throw InputError(complaint(loaded, "workload.samples.count", "at least 1: grip compares samples"));
}

grip::Settings settings_of(GripRequest const& request, WorkloadConfig const& workload) {
    grip::Settings settings;
    settings.neighbourhood = workload.observed_edges.neighbourhood;
    settings.threshold = workload.observed_edges.threshold;
    settings.inlier_distance = request.inlier_distance_m;
    return settings;
}

/// The untimed reference equals the model bit for bit.
std::vector<SampleCounters> flow_counters(AcceleratorConfig const& config, Stimulus const& stimulus) {
    reference::Scorer scorer = config.flow == Flow::fpga_grip ? reference::Scorer(stimulus, config.edge_extraction)
                                                              : reference::Scorer(stimulus, config.edge_map);
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
    return grip::score_poses(stimulus, settings, jobs,
                             [&line](std::size_t done, std::size_t all) { line.show(done, all); });
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
    comparison.grip = scores_by_grip(stimulus, settings_of(request, workload_of(config)), comparison.jobs);
    comparison.grip_seconds = seconds_since(start);
    start = HostClock::now();
    comparison.counters = flow_counters(accelerator_of(config), stimulus);
    comparison.reference_seconds = seconds_since(start);
    comparison.add_m = pose_errors(stimulus, workload::configured_pose(workload_of(config).target));
    return comparison;
}

}  // namespace

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
    say_warnings(stimulus_warnings(stimulus, workload_of(loaded.config)));
    announce(size_of(stimulus, jobs_or_host_cores(request.jobs)), request.force);
    GripComparison const comparison = compare_with_flow(request, loaded.config, stimulus);
    if (folder != nullptr) {
        io::write_file(folder->path() / "scores.csv", grip_csv(comparison));
        io::write_file(folder->path() / "summary.json", grip_json(comparison));
        folder->commit();
    }
    say("{}", grip_text(comparison));
    if (folder != nullptr)
        say("\nwritten: {}\n", request.out);
    return exit_done;
}

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
