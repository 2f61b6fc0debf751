#include "poses/commands/estimate_run.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <memory>
#include <set>

#include "dataflow/base/files/text_file.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/base/on_threads.hpp"
#include "dataflow/base/portable_math.hpp"
#include "dataflow/commands/options.hpp"
#include "dataflow/commands/progress_line.hpp"
#include "dataflow/run/config/choice_names.hpp"
#include "faster/config/faster_config.hpp"
#include "faster/workload/build_stimulus.hpp"
#include "faster/workload/files/png_image.hpp"
#include "faster/workload/files/trace.hpp"
#include "faster/workload/input_warnings.hpp"
#include "faster/workload/workload_source.hpp"
#include "modules/vertex_transform/explicit_triangles.hpp"
#include "poses/commands/estimate_pictures.hpp"
#include "poses/commands/estimate_scorers.hpp"
#include "poses/commands/estimate_size.hpp"

namespace faster {

namespace {

constexpr double degrees_per_radian = 180 / portable::pi;

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

}  // namespace

EstimateRun::EstimateRun(EstimateRequest const& request, LoadedConfig const& loaded)
    : request_(request),
      loaded_(loaded),
      jobs_(jobs_or_host_cores(request.jobs)),
      scene_(request.bop.folder.empty() ? configured_scene(loaded) : bop_scene(loaded, request.bop)) {}

std::vector<std::string> EstimateRun::warnings() const {
    if (!request_.bop.folder.empty())
        return {};
    Mesh mesh = scene_.observed.posed.mesh;  // in its own frame, as the configured pose is
    for (Eigen::Vector3d& vertex : mesh.vertices)
        vertex -= scene_.own_origin;
    std::vector<Pose> poses;
    for (estimation::TruePose const& truth : scene_.truths)
        poses.push_back(scene_.own(truth.pose));
    WorkloadConfig const& workload = workload_of(loaded_.config);
    std::vector<std::string> warnings = workload::input_warnings(workload, mesh, poses, scene_.observed.fraction);
    for (std::string const& unset : {unset_camera_warning(loaded_), unset_place_warning()})
        if (!unset.empty())
            warnings.push_back(unset);
    return warnings;
}

std::string EstimateRun::unset_place_warning() const {
    if (!scene_.truths.empty() || !scene_.boxes.empty())
        return {};
    return fmt::format(
        "workload.scene.depth_image = {}: neither estimator.box nor workload.pose is set, so samples begin "
        "all over the image; expected one of them",
        workload_of(loaded_.config).scene.depth_image);
}

WorkSize EstimateRun::size() const {
    WorkSize size;
    size.command = "estimate";
    size.amount = fmt::format("{} iterations of {} samples", estimator_of(loaded_.config).all_iterations(),
                              workload_of(loaded_.config).samples.count);
    size.seconds = seconds_of_estimate(loaded_.config, scene_.observed, !request_.untimed) / static_cast<double>(jobs_);
    return size;
}

void EstimateRun::find_pose() {
    EstimatorConfig const& config = estimator_of(loaded_.config);
    IterationCost cost;
    std::unique_ptr<IterationScorer> const scorer = simulates_at_once() ? make_simulating_scorer(loaded_, scene_, cost)
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

void EstimateRun::find_times(io::AtomicFolder* folder) {
    if (!is_timed() || simulates_at_once())
        return;
    std::vector<IterationCost> const costs =
        simulate_iterations(loaded_, scene_.observed, scored_, recorded_iteration(folder), jobs_);
    for (std::size_t i = 0; i < rows_.size(); ++i)
        set_cost(rows_[i], costs[i]);
}

EstimateReport EstimateRun::report() const {
    EstimatorConfig const& config = estimator_of(loaded_.config);
    EstimateReport report;
    report.object = request_.bop.folder.empty() ? workload_of(loaded_.config).target.object
                                                : fmt::format("object {}", request_.bop.object());
    report.scorer = scorer_name(loaded_.config);
    report.samples = workload_of(loaded_.config).samples.count;
    report.seed = config.seed;
    report.boxes = scene_.boxes;
    report.pose = scene_.own(pose_);
    report.weight = estimate_.weight;
    report.runs = estimate_.runs;
    report.run = estimate_.run;
    report.stopped_early = estimate_.ending == estimation::Ending::stop_weight;
    report.verdict = verdict_of(scene_, estimate_.weight, estimator_of(loaded_.config));
    if (estimation::TruePose const* const truth = nearest_truth(scene_, pose_))
        report.truth = scene_.own(truth->pose);
    report.distances = distances_from_truth(scene_, pose_);
    report.iterations = rows_;
    report.host = host_of(loaded_.config);
    if (config.refine != Refinement::none)
        add_refinement(report);
    report.keys = resolved_keys(loaded_.config, KeyScope::all);
    return report;
}

void EstimateRun::write(std::filesystem::path const& folder, EstimateReport const& report) const {
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

bool EstimateRun::is_timed() const {
    return !request_.untimed && estimator_of(loaded_.config).backend == EstimatorBackend::accelerator;
}

estimation::Score EstimateRun::score_of_mean() {
    if (!simulates_at_once())
        return {};
    return [this](std::vector<estimation::Particle> const& mean) {
        return make_scorer(loaded_.config, scene_, 1)->score(mean);
    };
}

std::optional<IterationRecording> EstimateRun::recorded_iteration(io::AtomicFolder* folder) const {
    if (!request_.records())
        return std::nullopt;
    std::uint64_t const iteration = request_.recorded_iteration.value_or(0);
    if (iteration >= scored_.size())
        throw InputError(fmt::format("--iteration {}: expected one of the estimate's {} iterations, from 0", iteration,
                                     scored_.size()));
    IterationRecording recording{iteration, request_.events, request_.recording, request_.force};
    if (folder != nullptr)
        for (std::string* const file :
             {&recording.events, &recording.request.vcd, &recording.request.fst, &recording.request.timeline})
            if (!file->empty())
                *file = folder->place_of(*file).string();
    return recording;
}

void EstimateRun::add_refinement(EstimateReport& report) const {
    double const ms = report.host.refine_us / 1000;
    report.refine_ms = ms;
    if (idle_w_)
        report.refine_mj = ms * *idle_w_;
}

void EstimateRun::set_cost(IterationRow& row, IterationCost const& cost) {
    idle_w_ = cost.idle_w;
    HostConfig const& host = host_of(loaded_.config);
    double const host_ms = (host.start_us + host.collect_us + host.resample_us) / 1000;
    row.cycles = cost.cycles;
    row.accelerator_ms = static_cast<double>(cost.cycles) / (accelerator_of(loaded_.config).clock_mhz * 1000);
    row.iteration_ms = *row.accelerator_ms + host_ms;
    row.energy_mj = cost.energy_mj + host_ms * cost.idle_w;
}

bop::PoseEstimate EstimateRun::bop_estimate(EstimateReport const& report) const {
    bop::PoseEstimate estimate;
    estimate.image = request_.bop.image();
    estimate.obj_id = request_.bop.object();
    estimate.score = report.weight;
    estimate.pose = report.pose;
    estimate.time_s = report.total_ms() ? *report.total_ms() / 1000 : -1;
    return estimate;
}

void EstimateRun::write_pictures(std::filesystem::path const& folder) const {
    constexpr std::size_t contours = 12;
    std::vector<DrawnIteration> drawn;
    for (std::uint64_t const k : chosen_iterations(request_.pictures, rows_.size())) {
        std::vector<Pose> const& poses = scored_[k].poses;
        DrawnIteration iteration{k, fmt::format("iteration {}: best weight {:.3f}", k, rows_[k].best_weight), {}, {}};
        iteration.poses.assign(poses.begin(),
                               poses.begin() + static_cast<std::ptrdiff_t>(std::min(contours, poses.size())));
        iteration.best = poses[rows_[k].best_sample];
        drawn.push_back(std::move(iteration));
    }
    EstimatePictures(scene_.observed, accelerator_of(loaded_.config), pose_).write(folder, drawn);
    files::write_colour_png(folder / "course.png", estimate_plots(rows_));
}

}  // namespace faster
