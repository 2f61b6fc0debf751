#include "poses/commands/evaluate_command.hpp"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fmt/format.h>
#include <map>
#include <memory>
#include <set>

#include "dataflow/base/files/atomic_folder.hpp"
#include "dataflow/base/files/json_file.hpp"
#include "dataflow/base/files/text_file.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/base/on_threads.hpp"
#include "dataflow/commands/command_paths.hpp"
#include "dataflow/commands/exit_codes.hpp"
#include "dataflow/commands/options.hpp"
#include "dataflow/commands/progress_line.hpp"
#include "dataflow/commands/say.hpp"
#include "dataflow/commands/work_size.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/workload/files/mesh_file.hpp"
#include "faster/workload/files/png_image.hpp"
#include "poses/bop/read_dataset.hpp"
#include "poses/commands/estimate_scene.hpp"
#include "poses/commands/pose_commands.hpp"
#include "poses/judging/accuracy_plot.hpp"
#include "poses/judging/evaluation.hpp"
#include "poses/judging/evaluation_json.hpp"
#include "poses/judging/evaluation_text.hpp"
#include "poses/judging/judge.hpp"
#include "poses/judging/model_symmetries.hpp"
#include "poses/judging/scores.hpp"

namespace faster {
namespace {

namespace fs = std::filesystem;

io::FolderKind const evaluation_folder{
    "evaluation",
    "evaluation.json",
    {"scores.csv", "errors.csv", "curves.csv", "accuracy_add_s.png", "accuracy_add.png", "evaluation.html"},
    "faster-evaluation"};

std::string method_name(std::string const& file) { return fs::path(file).stem().string(); }

/// Names stand in CSV files, and tell the methods apart.
void check_methods(std::vector<std::string> const& files) {
    std::set<std::string> names;
    for (std::string const& file : files) {
        std::string const name = method_name(file);
        if (name.find(',') != std::string::npos)
            throw InputError(file + ": has a comma in its name, expected none: the name is that of the method");
        if (!names.insert(name).second)
            throw InputError(
                fmt::format("{}: another file is called {} as well, expected each method once", file, name));
    }
}

bop::Dataset load_dataset(EvaluateRequest const& request) {
    bop::DatasetOptions options;
    options.split = request.split;
    options.models.assign(request.models.begin(), request.models.end());
    options.to_judge = true;
    options.unit_m = unit_of_models(request.models_in);
    return bop::read_dataset(request.files.back(), options);
}

/// Points to be mapped to compare an estimate with every pose of an object: once for each symmetry, for MSSD; and to
/// look for the nearest point, for ADD-S, takes as long as some 50.
double points_mapped(bop::ObjectModel const& model) {
    constexpr double bytes_of_point = 65;  // and of its triangles; binary files have fewer
    double const points = static_cast<double>(files::require_mesh_file(model.mesh)) / bytes_of_point;
    return points * (static_cast<double>(poses::symmetries_of(model).size()) + 50);
}

/// Every method judged at every target, and every draw of the bootstrap evaluated.
WorkSize size_of(bop::Dataset const& dataset, EvaluateRequest const& request) {
    constexpr double points_per_s = 1e9, instances_drawn_per_s = 25e6;  // measured with objects of YCB
    double mapped = 0, instances = 0;
    std::map<int, double> points;
    std::set<bop::ImageId> images;
    for (bop::Target const& target : dataset.targets) {
        auto const found = dataset.models.find(target.obj_id);
        if (found != dataset.models.end() && points.count(target.obj_id) == 0)
            points[target.obj_id] = points_mapped(found->second);
        auto const count = static_cast<double>(target.inst_count);
        mapped += count * count * points[target.obj_id];
        instances += count;
        images.insert(target.image);
    }
    auto const methods = static_cast<double>(request.files.size() - 1);
    auto const draws = static_cast<double>(request.replicates);
    auto const rows = static_cast<double>(2 * (points.size() + 2));  // a method's beside those of the first
    WorkSize size;
    size.command = "evaluate";
    size.amount =
        fmt::format("{:.0f} poses judged, {:.0f} draws of {} images", methods * instances, draws, images.size());
    size.seconds = methods * (mapped / points_per_s / static_cast<double>(jobs_or_host_cores(request.jobs)) +
                              draws * instances / instances_drawn_per_s);
    size.bytes = draws * (static_cast<double>(images.size() * sizeof(double)) + rows * sizeof(poses::Scores));
    return size;
}

/// Of the images that have a time; it is the whole image's, so any of its rows has it.
double mean_time_s(bop::Dataset const& dataset, std::vector<bop::PoseEstimate> const& estimates) {
    std::map<bop::ImageId, double> times;
    for (bop::PoseEstimate const& estimate : estimates) {
        if (estimate.time_s >= 0 && dataset.find(estimate.image) != nullptr)
            times.emplace(estimate.image, estimate.time_s);
    }
    double sum = 0;
    for (auto const& [image, time_s] : times)
        sum += time_s;
    return times.empty() ? -1 : sum / static_cast<double>(times.size());
}

/// Says each of them once, whichever method they came up with.
class Warnings {
  public:
    void say(std::vector<std::string> const& warnings) {
        for (std::string const& warning : warnings) {
            if (said_.insert(warning).second)
                say_warnings({warning});
        }
    }

  private:
    std::set<std::string> said_;
};

poses::JudgedMethod judged(bop::Dataset const& dataset, std::string const& file, poses::JudgeOptions const& options,
                           Warnings& warnings) {
    std::vector<std::string> of_file;
    auto const estimates = bop::read_pose_results(file, of_file);
    warnings.say(of_file);
    std::string const name = method_name(file);
    ProgressLine progress(name.c_str());
    auto judgement = poses::judge(dataset, estimates, file, options, progress.teller());
    warnings.say(judgement.warnings);
    return {name, std::move(judgement), mean_time_s(dataset, estimates)};
}

void write(poses::Evaluation const& evaluation, io::AtomicFolder& folder) {
    fs::path const& path = folder.path();
    io::write_file(path / "evaluation.json", io::text_of(poses::evaluation_json(evaluation), 1) + "\n");
    io::write_file(path / "scores.csv", poses::scores_csv(evaluation));
    io::write_file(path / "errors.csv", poses::errors_csv(evaluation));
    io::write_file(path / "curves.csv", poses::curves_csv(evaluation));
    io::write_file(path / "evaluation.html", poses::evaluation_html(evaluation));
    files::write_colour_png(path / "accuracy_add_s.png", poses::accuracy_plot(evaluation, poses::CurveOf::add_s));
    files::write_colour_png(path / "accuracy_add.png", poses::accuracy_plot(evaluation, poses::CurveOf::add));
    folder.commit();
}

}  // namespace

poses::Evaluation evaluate(EvaluateRequest const& request) {
    std::vector<std::string> const results(request.files.begin(), request.files.end() - 1);
    check_methods(results);
    CommandPaths paths;
    for (std::string const& file : request.files)
        paths.reads(file);
    paths.writes("--out", request.out, evaluation_folder);
    auto const folder =
        request.out.empty() ? nullptr : std::make_unique<io::AtomicFolder>(request.out, evaluation_folder);
    bop::Dataset const dataset = load_dataset(request);
    announce(size_of(dataset, request), request.force);
    Warnings warnings;
    warnings.say(dataset.warnings);
    warnings.say(dataset.warnings_of_targets);
    poses::JudgeOptions options;
    options.jobs = jobs_or_host_cores(request.jobs);
    options.vsd_delta_m = request.vsd_delta_mm / 1000;
    std::vector<poses::JudgedMethod> methods;
    methods.reserve(results.size());
    for (std::string const& file : results)
        methods.push_back(judged(dataset, file, options, warnings));
    poses::Evaluation evaluation = poses::evaluate(
        dataset, std::move(methods),
        {request.visible_from, static_cast<std::uint64_t>(request.seed), static_cast<std::size_t>(request.replicates)});
    if (folder)
        write(evaluation, *folder);
    say("{}", poses::evaluation_markdown(evaluation));
    say_written({request.out});
    return evaluation;
}

Subcommand evaluate_command() {
    return {"evaluate", "Judge estimated poses against a dataset in the format of BOP", [](CLI::App& command) {
                auto const request = std::make_shared<EvaluateRequest>();
                command
                    .add_option("files", request->files,
                                "Files of results (CSV as BOP has it), one per method, and then the dataset's folder; "
                                "the first method is what others are compared with")
                    ->required()
                    ->expected(2, CLI::detail::expected_max_vector_size)
                    ->type_name("RESULTS... DATASET");
                command.add_option("--out", request->out, "Write tables, plots and a page to this folder")
                    ->type_name("DIR");
                repeats(*command
                             .add_option("--models", request->models,
                                         "Look for meshes and models_info.json in this folder first, then in the "
                                         "dataset; may be repeated")
                             ->type_name("DIR"));
                command.add_option("--models-in", request->models_in, "Unit of the meshes, m or mm (mm, of frames m)")
                    ->check(one_of({"m", "mm"}))
                    ->type_name("UNIT");
                command.add_option("--split", request->split, "Folder of the dataset's scenes; by default test")
                    ->type_name("NAME");
                command
                    .add_option("--visible-from", request->visible_from,
                                "Only instances of which at least this share is visible, as annotated")
                    ->type_name("SHARE")
                    ->check(number_in(0, 1));
                command
                    .add_option("--vsd-delta-mm", request->vsd_delta_mm,
                                "VSD: how far behind a reading a pixel still counts as visible; BOP has 5 for ITODD")
                    ->type_name("MM")
                    ->check(number_in(0, 1000))
                    ->capture_default_str();
                command.add_option("--seed", request->seed, "Of the bootstrap")
                    ->type_name("N")
                    ->check(integer_in(0, 9'000'000'000'000'000'000))
                    ->capture_default_str();
                command.add_option("--bootstraps", request->replicates, "How often to draw the images anew")
                    ->type_name("N")
                    ->check(integer_in(0, 1000000))
                    ->capture_default_str();
                add_jobs(command, request->jobs, "Threads");
                add_force(command, request->force);
                return [request] {
                    evaluate(*request);
                    return exit_done;
                };
            }};
}

}  // namespace faster
