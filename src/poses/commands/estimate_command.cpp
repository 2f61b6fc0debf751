#include <fmt/format.h>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "dataflow/base/files/atomic_folder.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/commands/command_paths.hpp"
#include "dataflow/commands/exit_codes.hpp"
#include "dataflow/commands/options.hpp"
#include "dataflow/commands/recording_options.hpp"
#include "dataflow/commands/say.hpp"
#include "dataflow/commands/work_size.hpp"
#include "dataflow/run/config/choice_names.hpp"
#include "dataflow/run/config/load_config.hpp"
#include "faster/config/faster_config.hpp"
#include "faster/dataflow_names.hpp"
#include "poses/commands/estimate_all.hpp"
#include "poses/commands/estimate_report.hpp"
#include "poses/commands/estimate_run.hpp"
#include "poses/commands/pose_commands.hpp"
#include "poses/commands/timed_iterations.hpp"

namespace faster {

namespace {

io::FolderKind const estimate_folder{
    "results of an estimate",
    "estimate.json",
    {"iterations.csv", "bop.csv", "images/course.png", "images/convergence.png", "images/iteration_*.png",
     "traces/iteration_*/*.csv", "traces/iteration_*/*.png", "traces/iteration_*/trace.yaml"},
    "faster-estimate"};

std::vector<std::string> overrides_of(EstimateRequest const& request) {
    std::vector<std::string> overrides = request.overrides;
    if (!request.backend.empty())
        overrides.push_back("estimator.backend=" + request.backend);
    return overrides;
}

int estimate_all_of(EstimateRequest const& request, LoadedConfig const& loaded) {
    if (request.bop.folder.empty() || request.out.empty())
        throw InputError("--all: expected --bop DIR and --out DIR as well");
    bool const is_of_one = request.bop.scene_id || request.bop.im_id || request.bop.obj_id || !request.traces.empty() ||
                           !request.pictures.empty() || request.records();
    if (is_of_one)
        throw InputError(
            "--all: expected none of --scene, --image, --object, --pictures, --traces, --events, --vcd and --timeline, "
            "which are of one object");
    return estimate_all({request.bop, request.out, request.jobs, request.force}, loaded);
}

void refuse_without_what_they_need(EstimateRequest const& request, RunConfig const& config) {
    std::uint64_t const iterations = estimator_of(config).all_iterations();
    for (auto const& [option, chosen] : {std::pair("--pictures", &request.pictures), {"--traces", &request.traces}}) {
        if (!chosen->empty() && request.out.empty())
            throw InputError(fmt::format("{}: expected --out DIR as well", option));
        for (std::uint64_t const iteration : *chosen)
            if (iteration >= iterations)
                throw InputError(fmt::format("{} {}: expected iterations from 0 to {} (estimator.iterations)", option,
                                             iteration, iterations - 1));
    }
    if (request.recorded_iteration && !request.records())
        throw InputError("--iteration: expected --events, --vcd, --fst or --timeline as well");
    if (!request.recording.has_waveform())
        refuse_without_waveform(request.recording);
}

/// Looks for an object's pose by the thesis's second stage. Throws InputError on bad input. Exit code 3 if the
/// accelerator deadlocks.
int estimate_pose(EstimateRequest const& request) {
    LoadedConfig const loaded = load_config(request.config, overrides_of(request));
    if (request.all)
        return estimate_all_of(request, loaded);
    refuse_without_what_they_need(request, loaded.config);
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
        warn("{}", deadlock.what());
        return exit_deadlock;
    }
    EstimateReport const report = run.report();
    if (folder != nullptr) {
        run.write(folder->path(), report);
        folder->commit();
    }
    say("{}", estimate_text(report));
    say_written({request.out, request.events, written_files(request.recording)});
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
            command.add_option("--split", request->bop.split, "Folder of the dataset's scenes; by default test")
                ->type_name("NAME")
                ->needs("--bop");
            command.add_option("--scene", request->bop.scene_id, "Of the dataset (0)")->type_name("N")->needs("--bop");
            command.add_option("--image", request->bop.im_id, "Of the scene (0)")->type_name("N")->needs("--bop");
            command.add_option("--object", request->bop.obj_id, "obj_id of the object")->type_name("N")->needs("--bop");
            command
                .add_option("--detections", request->bop.detections,
                            "Boxes from this file (JSON as BOP has it) instead of the annotated ones")
                ->type_name("FILE")
                ->needs("--bop");
            command.add_flag("--all", request->all,
                             "Every target of the dataset, without cycles: results.csv in the folder of --out, which "
                             "goes on where it was");
            command
                .add_option("--models-in", request->bop.models_in,
                            "Unit of the dataset's meshes, m or mm (mm, of frames m)")
                ->check(one_of({"m", "mm"}))
                ->type_name("UNIT")
                ->needs("--bop");
            add_jobs(command, request->jobs, "Threads, and simulations at once");
            command.add_option("--backend", request->backend, "Who scores, for estimator.backend")
                ->check(one_of(names_of_choices<EstimatorBackend>()))
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
