#include <algorithm>
#include <cstdint>
#include <fmt/format.h>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "dataflow/base/files/atomic_folder.hpp"
#include "dataflow/base/files/text_file.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/base/on_threads.hpp"
#include "dataflow/base/portable_math.hpp"
#include "dataflow/commands/command_paths.hpp"
#include "dataflow/commands/exit_codes.hpp"
#include "dataflow/commands/options.hpp"
#include "dataflow/commands/progress_line.hpp"
#include "dataflow/commands/recording_options.hpp"
#include "dataflow/commands/say.hpp"
#include "dataflow/commands/work_size.hpp"
#include "dataflow/run/config/load_config.hpp"
#include "faster/config/enum_names.hpp"
#include "faster/config/faster_config.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/workload/build_stimulus.hpp"
#include "faster/workload/files/png_image.hpp"
#include "faster/workload/files/trace.hpp"
#include "faster/workload/input_warnings.hpp"
#include "modules/vertex_transform/explicit_triangles.hpp"
#include "poses/bop/pose_results.hpp"
#include "poses/commands/estimate_all.hpp"
#include "poses/commands/estimate_pictures.hpp"
#include "poses/commands/estimate_report.hpp"
#include "poses/commands/estimate_scene.hpp"
#include "poses/commands/estimate_scorers.hpp"
#include "poses/commands/estimate_size.hpp"
#include "poses/commands/pose_commands.hpp"
#include "poses/commands/timed_iterations.hpp"
#include "poses/estimation/estimator.hpp"

namespace faster {

namespace {

/// `faster-sim estimate`.
struct EstimateRequest {
    std::string config;
    std::vector<std::string> overrides;
    std::string out;                      ///< folder; empty: print only
    std::string backend;                  ///< stands for estimator.backend; empty: as configured
    std::vector<std::uint64_t> pictures;  ///< iterations to draw; empty: a choice of them
    std::vector<std::uint64_t> traces;    ///< iterations to write as stimulus traces
    std::int64_t jobs = 0;                ///< threads and processes; 0: the host's cores
    BopRequest bop;                       ///< instead of the configured workload
    bool all = false;                     ///< every target of the dataset
    bool untimed = false;                 ///< without the accelerator's cycles
    std::uint64_t recorded_iteration = 0;
    std::string events;          ///< file of that iteration's events; empty: none
    RecordingRequest recording;  ///< of that iteration
    bool force = false;          ///< however long it takes, and even a waveform of more than 2 GB

    bool records() const { return !events.empty() || recording.has_waveform() || !recording.timeline.empty(); }
};

constexpr double degrees_per_radian = 180 / portable::pi;

io::FolderKind const estimate_folder{
    "results of an estimate",
    "estimate.json",
    {"iterations.csv", "bop.csv", "images/course.png", "images/convergence.png", "images/iteration_*.png",
     "traces/iteration_*/*.csv", "traces/iteration_*/*.png", "traces/iteration_*/trace.yaml"},
    "faster-estimate"};

/// Which iterations are wanted: those asked for, or else a few of all.
std::set<std::uint64_t> chosen_iterations(std::vector<std::uint64_t> const& asked, std::uint64_t count) {
    std::set<std::uint64_t> chosen;
    if (asked.empty()) {
        for (std::uint64_t k = 0; k < count; k = k < 2 ? k + 1 : 2 * k + 1)
            chosen.insert(k);
        chosen.insert(count - 1);
    }
    for (std::uint64_t const k : asked)
        if (k < count)
            chosen.insert(k);
    return chosen;
}

IterationRow row_of(estimation::Iteration const& iteration, estimation::Scene const& scene) {
    IterationRow row;
    row.run = iteration.run;
    row.best_sample = iteration.best;
    row.best_weight = iteration.best_weight();
    row.mean_weight = iteration.mean_weight;
    row.effective_samples = iteration.effective_samples;
    row.spread_mm = 1000 * iteration.spread_m;
    row.spread_deg = degrees_per_radian * iteration.spread_rad;
    row.translation_sigma_mm = 1000 * iteration.noise.translation_m;
    row.rotation_sigma_deg = degrees_per_radian * iteration.noise.rotation_rad;
    row.best = distances_from_truth(scene, pose_of(iteration.particles[iteration.best], scene.size));
    return row;
}

/// The loop, and all that is kept of it.
class EstimateRun {
  public:
    EstimateRun(EstimateRequest const& request, LoadedConfig const& loaded)
        : request_(request),
          loaded_(loaded),
          jobs_(jobs_or_host_cores(request.jobs)),
          scene_(request.bop.folder.empty() ? configured_scene(loaded) : bop_scene(loaded, request.bop)) {}

    /// Of a configured scene: a dataset says its units itself.
    std::vector<std::string> warnings() const {
        if (!request_.bop.folder.empty())
            return {};
        return workload::input_warnings(workload_of(loaded_.config), scene_.observed.posed.mesh, {*scene_.truth});
    }

    WorkSize size() const {
        WorkSize size;
        size.command = "estimate";
        size.amount = fmt::format("{} iterations of {} samples", estimator_of(loaded_.config).all_iterations(),
                                  workload_of(loaded_.config).samples.count);
        size.seconds =
            seconds_of_estimate(loaded_.config, scene_.observed, !request_.untimed) / static_cast<double>(jobs_);
        return size;
    }

    void find_pose() {
        EstimatorConfig const& config = estimator_of(loaded_.config);
        IterationCost cost;
        std::unique_ptr<IterationScorer> const scorer = simulates_at_once()
                                                            ? make_simulating_scorer(loaded_, scene_, cost)
                                                            : make_scorer(loaded_.config, scene_, jobs_);
        ProgressLine progress("iterations");
        estimate_ = estimation::estimate(
            scene_, config, workload_of(loaded_.config).samples.count,
            [&](std::vector<estimation::Particle> const& particles) { return scorer->score(particles); },
            [&](estimation::Iteration const& iteration) {
                rows_.push_back(row_of(iteration, scene_));
                rows_.back().number = rows_.size() - 1;
                scored_.push_back(scorer->last());
                if (simulates_at_once())
                    set_cost(rows_.back(), cost);
                progress.show(rows_.size(), config.all_iterations());
            },
            score_of_mean());
        pose_ = final_pose(scene_, estimate_.particle, config);
    }

    void find_times(io::AtomicFolder* folder) {
        if (!is_timed() || simulates_at_once())
            return;
        std::vector<IterationCost> const costs =
            simulate_iterations(loaded_, scene_.observed, scored_, recorded_iteration(folder), jobs_);
        for (std::size_t i = 0; i < rows_.size(); ++i)
            set_cost(rows_[i], costs[i]);
    }

    EstimateReport report() const {
        EstimatorConfig const& config = estimator_of(loaded_.config);
        EstimateReport report;
        report.object = request_.bop.folder.empty() ? workload_of(loaded_.config).target.object
                                                    : fmt::format("object {}", request_.bop.obj_id);
        report.scorer = scorer_name(loaded_.config);
        report.samples = workload_of(loaded_.config).samples.count;
        report.seed = config.seed;
        report.boxes = scene_.boxes;
        report.pose = scene_.own(estimated_pose());
        report.weight = estimate_.weight;
        report.runs = estimate_.runs;
        report.run = estimate_.run;
        report.stopped_early = estimate_.ending == estimation::Ending::stop_weight;
        report.verdict = verdict_of(scene_, estimate_.weight, estimator_of(loaded_.config));
        if (scene_.truth)
            report.truth = scene_.own(*scene_.truth);
        report.distances = distances_from_truth(scene_, estimated_pose());
        report.iterations = rows_;
        report.host = host_of(loaded_.config);
        if (config.refine != Refinement::none)
            add_refinement(report);
        report.keys = resolved_keys(loaded_.config, KeyScope::all);
        return report;
    }

    void write(std::filesystem::path const& folder, EstimateReport const& report) const {
        io::write_file(folder / "estimate.json", estimate_json(report));
        io::write_file(folder / "iterations.csv", estimate_csv(report));
        write_pictures(folder / "images");
        if (!request_.bop.folder.empty())
            io::write_file(folder / "bop.csv", bop::pose_results_csv({bop_estimate(report)}));
        for (std::uint64_t const k : request_.traces)
            if (k < scored_.size()) {
                Stimulus stimulus = scene_.observed;
                workload::set_poses(scored_[k].poses, stimulus);
                files::write_trace(with_explicit_triangles(std::move(stimulus)),
                                   folder / "traces" / fmt::format("iteration_{:04}", k));
            }
    }

  private:
    bool is_timed() const {
        return !request_.untimed && estimator_of(loaded_.config).backend == EstimatorBackend::accelerator;
    }
    /// One host core need not score without time first: several simulate iterations of which the scores are known.
    bool simulates_at_once() const { return is_timed() && jobs_ == 1 && !request_.records(); }

    /// Of no iteration, so it is not simulated; empty: it is scored as the samples are.
    estimation::Score score_of_mean() {
        if (!simulates_at_once())
            return {};
        return [this](std::vector<estimation::Particle> const& mean) {
            return make_scorer(loaded_.config, scene_, 1)->score(mean);
        };
    }

    /// Nothing if there is nothing to record. What is to be in the folder in the end is written to its place there.
    std::optional<IterationRecording> recorded_iteration(io::AtomicFolder* folder) const {
        if (!request_.records())
            return std::nullopt;
        if (request_.recorded_iteration >= scored_.size())
            throw InputError(fmt::format("--iteration {}: expected one of the estimate's {} iterations, from 0",
                                         request_.recorded_iteration, scored_.size()));
        IterationRecording recording{request_.recorded_iteration, request_.events, request_.recording, request_.force};
        if (folder != nullptr)
            for (std::string* const file :
                 {&recording.events, &recording.request.vcd, &recording.request.fst, &recording.request.timeline})
                if (!file->empty())
                    *file = folder->place_of(*file).string();
        return recording;
    }

    /// Of the frame of the scene's mesh.
    Pose const& estimated_pose() const { return pose_; }

    void add_refinement(EstimateReport& report) const {
        double const ms = report.host.refine_us / 1000;
        report.refine_ms = ms;
        if (idle_w_)
            report.refine_mj = Estimate{idle_w_->low * ms, idle_w_->typical * ms, idle_w_->high * ms};
    }

    void set_cost(IterationRow& row, IterationCost const& cost) {
        idle_w_ = cost.idle_w;
        HostConfig const& host = host_of(loaded_.config);
        double const host_ms = (host.start_us + host.collect_us + host.resample_us) / 1000;
        row.cycles = cost.cycles;
        row.accelerator_ms = static_cast<double>(cost.cycles) / (accelerator_of(loaded_.config).clock_mhz * 1000);
        row.iteration_ms = *row.accelerator_ms + host_ms;
        row.energy_mj = Estimate{cost.energy_mj.low + cost.idle_w.low * host_ms,
                                 cost.energy_mj.typical + cost.idle_w.typical * host_ms,
                                 cost.energy_mj.high + cost.idle_w.high * host_ms};
    }

    bop::PoseEstimate bop_estimate(EstimateReport const& report) const {
        bop::PoseEstimate estimate;
        estimate.image = {request_.bop.scene_id, request_.bop.im_id};
        estimate.obj_id = request_.bop.obj_id;
        estimate.score = report.weight;
        estimate.pose = report.pose;
        estimate.time_s = report.total_ms() ? *report.total_ms() / 1000 : -1;
        return estimate;
    }

    void write_pictures(std::filesystem::path const& folder) const {
        constexpr std::size_t contours = 12;
        std::vector<DrawnIteration> drawn;
        for (std::uint64_t const k : chosen_iterations(request_.pictures, rows_.size())) {
            std::vector<Pose> const& poses = scored_[k].poses;
            DrawnIteration iteration{
                k, fmt::format("iteration {}: best weight {:.3f}", k, rows_[k].best_weight), {}, {}};
            iteration.poses.assign(poses.begin(),
                                   poses.begin() + static_cast<std::ptrdiff_t>(std::min(contours, poses.size())));
            iteration.best = poses[rows_[k].best_sample];
            drawn.push_back(std::move(iteration));
        }
        EstimatePictures(scene_.observed, accelerator_of(loaded_.config), estimated_pose()).write(folder, drawn);
        files::write_colour_png(folder / "course.png", estimate_plots(rows_));
    }

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

std::vector<std::string> overrides_of(EstimateRequest const& request) {
    std::vector<std::string> overrides = request.overrides;
    if (!request.backend.empty())
        overrides.push_back("estimator.backend=" + request.backend);
    return overrides;
}

int estimate_all_of(EstimateRequest const& request, LoadedConfig const& loaded) {
    if (request.bop.folder.empty() || request.out.empty())
        throw InputError("--all: expected --bop DIR and --out DIR as well");
    bool const is_of_one = request.bop.scene_id != 0 || request.bop.im_id != 0 || request.bop.obj_id != 0 ||
                           !request.traces.empty() || !request.pictures.empty() || request.records();
    if (is_of_one)
        throw InputError(
            "--all: expected none of --scene, --image, --object, --pictures, --traces, --events, --vcd and --timeline, "
            "which are of one object");
    return estimate_all({request.bop, request.out, request.jobs, request.force}, loaded);
}

/// Looks for an object's pose by the thesis's second stage. Throws InputError on bad input. Exit code 3 if the
/// accelerator deadlocks.
int estimate_pose(EstimateRequest const& request) {
    LoadedConfig const loaded = load_config(request.config, overrides_of(request));
    if (request.all)
        return estimate_all_of(request, loaded);
    if (!request.traces.empty() && request.out.empty())
        throw InputError("--traces: expected --out DIR as well");
    if (request.records() && (request.untimed || estimator_of(loaded.config).backend == EstimatorBackend::grip))
        throw InputError("--events, --vcd and --timeline: expected neither --untimed nor the backend grip with them");
    CommandPaths paths;
    for (std::string const& input : {request.config, request.bop.folder, request.bop.detections})
        paths.reads(input);
    paths.reads(loaded.config);
    paths.writes("--out", request.out, estimate_folder);
    paths.writes("--events", request.events);
    add_paths(request.recording, paths);
    std::unique_ptr<io::AtomicFolder> const folder =
        request.out.empty() ? nullptr : std::make_unique<io::AtomicFolder>(request.out, estimate_folder);
    EstimateRun run(request, loaded);
    say_warnings(run.warnings());
    announce(run.size(), request.force);
    try {
        run.find_pose();
        run.find_times(folder.get());
    } catch (DeadlockedIteration const& deadlock) {
        fmt::print(stderr, "{}", deadlock.what());
        return exit_deadlock;
    }
    EstimateReport const report = run.report();
    if (folder != nullptr) {
        run.write(folder->path(), report);
        folder->commit();
    }
    fmt::print("{}", estimate_text(report));
    if (folder != nullptr)
        fmt::print("\nwritten: {}\n", request.out);
    for (std::string const& written : {request.events, written_files(request.recording)})
        if (!written.empty())
            fmt::print("\nwritten: {}\n", written);
    return exit_done;
}

}  // namespace

Subcommand estimate_command() {
    return {
        "estimate", "Find the object's pose: score samples, resample, diffuse, in many iterations (thesis 2.1, 4.2.1)",
        [](CLI::App& command) {
            auto const request = std::make_shared<EstimateRequest>();
            command.add_option("config", request->config, "Configuration file (YAML)")->required()->type_name("CONFIG");
            command.add_option("--out", request->out, "Write estimate.json, iterations.csv and images to this folder")
                ->type_name("DIR");
            add_overrides(command, request->overrides);
            command.add_option("--bop", request->bop.folder, "Look for an object of this dataset (BOP)")
                ->type_name("DIR");
            command.add_option("--scene", request->bop.scene_id, "Of the dataset")->type_name("N");
            command.add_option("--image", request->bop.im_id, "Of the scene")->type_name("N");
            command.add_option("--object", request->bop.obj_id, "obj_id of the object")->type_name("N");
            command
                .add_option("--detections", request->bop.detections,
                            "Boxes from this file (JSON as BOP has it) instead of the annotated ones")
                ->type_name("FILE");
            command.add_flag("--all", request->all,
                             "Every target of the dataset, without cycles: results.csv in the folder of --out, which "
                             "goes on where it was");
            command.add_option("--models-in", request->bop.models_in, "Unit of the dataset's meshes, m or mm (mm)")
                ->check(CLI::IsMember({"m", "mm"}))
                ->type_name("UNIT");
            add_jobs(command, request->jobs, "Threads, and simulations at once");
            command.add_option("--backend", request->backend, "accelerator or grip, for estimator.backend")
                ->type_name("NAME");
            command.add_flag("--untimed", request->untimed, "Without the accelerator's cycles");
            command.add_option("--pictures", request->pictures, "Draw these iterations, e.g. 0,5,49 (a choice)")
                ->delimiter(',')
                ->allow_extra_args(false)
                ->type_name("LIST");
            command
                .add_option("--traces", request->traces,
                            "Write these iterations as stimulus traces, for run --trace with --vcd or --events")
                ->delimiter(',')
                ->allow_extra_args(false)
                ->type_name("LIST");
            command
                .add_option("--iteration", request->recorded_iteration,
                            "The one that --events, --vcd and --timeline record (0)")
                ->type_name("N");
            command
                .add_option("--events", request->events, "Write what that iteration did, for whatif and sensitivities")
                ->type_name("FILE");
            add_recording_options(command, request->recording);
            add_force(command, request->force, ", or writes a waveform of more than 2 GB");
            return [request] { return estimate_pose(*request); };
        }};
}

}  // namespace faster
