#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <fmt/format.h>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "dataflow/base/files/folder_lock.hpp"
#include "dataflow/base/files/output_file.hpp"
#include "dataflow/base/files/text_file.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/base/on_threads.hpp"
#include "dataflow/commands/exit_codes.hpp"
#include "dataflow/commands/options.hpp"
#include "dataflow/commands/progress_line.hpp"
#include "dataflow/commands/say.hpp"
#include "dataflow/commands/work_size.hpp"
#include "dataflow/run/config/load_config.hpp"
#include "dataflow/tools/sweeps/journal_rows.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/workload/files/png_image.hpp"
#include "poses/bop/read_dataset.hpp"
#include "poses/commands/estimate_scene.hpp"
#include "poses/commands/estimate_worker.hpp"
#include "poses/commands/evaluate_command.hpp"
#include "poses/commands/experiment_estimates.hpp"
#include "poses/commands/experiment_failures.hpp"
#include "poses/commands/pose_commands.hpp"
#include "poses/experiments/boxes_of_detector.hpp"
#include "poses/experiments/experiment_file.hpp"
#include "poses/experiments/made_dataset.hpp"
#include "poses/experiments/scene_meshes.hpp"
#include "poses/judging/counted_poses.hpp"

namespace faster {

namespace {

/// `faster-sim experiment`.
struct ExperimentRequest {
    std::string file;
    std::string out;
    std::int64_t jobs = 0;     ///< processes at once; 0: the host's cores
    bool force = false;        ///< however long it takes
    std::size_t failures = 8;  ///< pictures of a setting
};
constexpr std::size_t most_failures = 10000;
constexpr double certain = 1;  // of whoever annotates

namespace fs = std::filesystem;

std::vector<MethodData> methods_of(experiments::Experiment const& experiment) {
    std::vector<fs::path> files;
    if (!experiment.base.empty())
        files.push_back(experiment.base);
    std::vector<MethodData> methods;
    for (experiments::Method const& method : experiment.methods) {
        std::vector<std::string> settings = experiment.settings;
        settings.insert(settings.end(), method.settings.begin(), method.settings.end());
        try {
            methods.push_back({method.name, layered_config(files, settings)});
            require_estimable(methods.back().loaded);
            std::vector<std::string> warnings = idle_keys_of_datasets(methods.back().loaded);
            for (std::string& warning : warnings)
                warning = fmt::format("{}: methods.{}: {}", experiment.file, method.name, warning);
            say_warnings(warnings);
        } catch (InputError const& error) {
            throw InputError(fmt::format("{}: methods.{}: {}", experiment.file, method.name, error.what()));
        }
    }
    return methods;
}

/// Boxes of the objects of an image, as annotated.
class AnnotatedBoxes {
  public:
    explicit AnnotatedBoxes(bop::Dataset const& dataset) : dataset_(dataset) {}

    std::vector<std::string> const& warnings() const { return warnings_; }

    /// Of what is to be found.
    std::vector<bop::ImageBox> of(bop::Target const& target) {
        return of(poses::most_visible(dataset_, target), target);
    }

    std::vector<bop::ImageBox> of_others(bop::Target const& target) {
        poses::Truths others;
        for (bop::GroundTruth const& object : dataset_.find(target.image)->objects)
            if (object.obj_id != target.obj_id)
                others.push_back(&bop::sound(object));
        return of(others, target);
    }

  private:
    std::vector<bop::ImageBox> of(poses::Truths const& objects, bop::Target const& target) {
        std::vector<bop::ImageBox> boxes;
        for (bop::Detection const& annotated : annotated_boxes(
                 objects, target.image, dataset_.find(target.image)->camera,
                 [this](int obj_id) -> Mesh const& { return mesh(obj_id); }, certain))
            boxes.push_back(annotated.box);
        return boxes;
    }

    Mesh const& mesh(int obj_id) {
        auto const found = meshes_.find(obj_id);
        if (found != meshes_.end())
            return found->second;
        return meshes_[obj_id] = bop::load_model(bop::model_of(dataset_, obj_id, dataset_.folder.string()), warnings_);
    }

    bop::Dataset const& dataset_;
    std::map<int, Mesh> meshes_;
    std::vector<std::string> warnings_;
};

SettingData data_of(experiments::Setting const& setting, fs::path const& folder, std::uint64_t seed) {
    SettingData data;
    data.name = setting.name;
    data.dataset = bop::read_dataset(folder);
    AnnotatedBoxes annotated(data.dataset);
    for (bop::Target const& target : data.dataset.targets) {
        std::vector<bop::ImageBox> const boxes = annotated.of(target), others = annotated.of_others(target);
        for (std::size_t i = 0; i < boxes.size(); ++i)
            for (bop::Detection const& seen :
                 experiments::boxes_of_detector(target, i, boxes[i], others, setting.boxes, seed))
                data.boxes[{target.image, target.obj_id}].push_back(seen);
    }
    say_warnings(data.dataset.warnings);
    say_warnings(data.dataset.warnings_of_targets);
    say_warnings(annotated.warnings());
    return data;
}

std::vector<bop::Detection> all_boxes(SettingData const& setting) {
    std::vector<bop::Detection> all;
    for (auto const& [target, boxes] : setting.boxes)
        all.insert(all.end(), boxes.begin(), boxes.end());
    return all;
}

/// Scenes of all settings; those that are made are in folders of their names.
std::vector<SettingData> prepared(experiments::Experiment const& experiment, fs::path const& out, std::size_t jobs) {
    std::vector<SettingData> settings;
    for (experiments::Setting const& setting : experiment.scenes) {
        fs::path const made = out / "scenes" / setting.name;
        if (setting.dataset.empty()) {
            fs::create_directories(out / "scenes");
            std::vector<std::string> odd_meshes;
            std::map<int, Mesh> meshes = experiments::scene_meshes(setting.models, jobs, odd_meshes);
            say_warnings(odd_meshes);
            ProgressLine progress("scenes");
            std::size_t const missed =
                experiments::make_dataset(made, setting, std::move(meshes), experiment.seed, jobs, progress.teller());
            if (missed > 0)
                say_warnings(
                    {fmt::format("{}: scenes.{}.visible = [{}, {}]: in {} images no try came near it, and the "
                                 "nearest was taken; scene_gt_info.json says how much is visible",
                                 experiment.file, setting.name, setting.visible[0], setting.visible[1], missed)});
        }
        settings.push_back(data_of(setting, setting.dataset.empty() ? made : setting.dataset, experiment.seed));
        fs::create_directories(out / "boxes");
        io::write_file_atomically(out / "boxes" / (setting.name + ".json"),
                                  bop::detections_json(all_boxes(settings.back())));
    }
    return settings;
}

/// Of the largest number that a share of `values` does not exceed.
double quantile(std::vector<double> values, double share) {
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

/// A row per setting, method and iteration. Who stopped earlier stays where it was.
std::string convergence_csv(std::vector<WantedEstimate> const& wanted, experiments::EstimateJournal const& journal,
                            std::vector<SettingData> const& settings, std::vector<MethodData> const& methods) {
    std::string text = "setting,method,iteration,estimates,median_adds_mm,share_below_20_mm\n";
    for (SettingData const& setting : settings)
        for (MethodData const& method : methods) {
            std::vector<std::vector<double>> all;
            for_each_result(wanted, journal, setting, method,
                            [&](WantedEstimate const&, experiments::EstimateResult const& result) {
                                if (!result.adds_mm.empty())
                                    all.push_back(result.adds_mm);
                            });
            std::size_t most = 0;
            for (std::vector<double> const& each : all)
                most = std::max(most, each.size());
            for (std::size_t k = 0; k < most; ++k) {
                std::vector<double> errors;
                errors.reserve(all.size());
                for (std::vector<double> const& each : all)
                    errors.push_back(each[std::min(k, each.size() - 1)]);
                auto const below = std::count_if(errors.begin(), errors.end(), [](double mm) { return mm < 20; });
                fmt::format_to(std::back_inserter(text), "{},{},{},{},{:.3f},{:.4f}\n", setting.name, method.name, k,
                               errors.size(), quantile(errors, 0.5),
                               static_cast<double>(below) / static_cast<double>(errors.size()));
            }
        }
    return text;
}

/// A row per estimate.
std::string estimates_csv(std::vector<WantedEstimate> const& wanted, experiments::EstimateJournal const& journal,
                          JudgedErrors const& errors) {
    std::string text = "setting,method,scene_id,im_id,obj_id,boxes,weight,truth_weight,verdict,adds_mm\n";
    for (WantedEstimate const& each : wanted)
        if (experiments::EstimateResult const* const result = journal.find(each.id)) {
            std::optional<poses::EstimateErrors> const off = errors.of(each);
            fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{:.6f},{:.6f},{},{}\n", each.setting->name,
                           each.method->name, each.target.image.scene_id, each.target.image.im_id, each.target.obj_id,
                           each.boxes.size(), result->weight, result->truth_weight, result->verdict,
                           off ? fmt::format("{:.4f}", 1000 * off->add_s_m) : "");
        }
    return text;
}

void judge(fs::path const& out, std::vector<WantedEstimate> const& wanted, experiments::EstimateJournal const& journal,
           SettingData const& setting, std::vector<MethodData> const& methods, std::size_t jobs, bool force,
           JudgedErrors& errors) {
    EvaluateRequest request;
    request.force = force;
    for (MethodData const& method : methods)
        request.files.push_back((out / "results" / setting.name / (method.name + ".csv")).string());
    request.files.push_back(setting.dataset.folder.string());
    request.out = (out / "evaluation" / setting.name).string();
    request.jobs = static_cast<std::int64_t>(jobs);
    say("\n# {}\n\n", setting.name);
    poses::Evaluation const evaluation = evaluate(request);
    for (std::size_t i = 0; i < methods.size(); ++i)
        errors.add(setting, methods[i], wanted, journal, evaluation.methods[i].judgement);
}

void write_results(fs::path const& out, std::vector<WantedEstimate> const& wanted,
                   experiments::EstimateJournal const& journal, std::vector<SettingData> const& settings,
                   std::vector<MethodData> const& methods) {
    for (SettingData const& setting : settings) {
        fs::create_directories(out / "results" / setting.name);
        for (MethodData const& method : methods)
            io::write_file_atomically(out / "results" / setting.name / (method.name + ".csv"),
                                      results_of(wanted, journal, setting, method));
    }
    io::write_file_atomically(out / "convergence.csv", convergence_csv(wanted, journal, settings, methods));
}

/// Which estimates are wrong, why, and what the worst look like.
void write_failures(fs::path const& out, std::vector<Failure> const& failures, std::vector<SettingData> const& settings,
                    std::size_t pictures) {
    io::write_file_atomically(out / "failures.csv", failures_csv(failures));
    fs::create_directories(out / "failures");
    for (SettingData const& setting : settings) {
        fs::path const file = out / "failures" / (setting.name + ".png");
        std::vector<Failure> const worst = worst_of(failures, setting, pictures);
        if (worst.empty())
            fs::remove(file);
        else
            io::write_file_atomically(file, files::colour_png(failure_sheet(worst)));
    }
}

/// How far the verdict may be believed: estimates of each, and how many of them are right.
std::string verdicts_table(std::vector<WantedEstimate> const& wanted, experiments::EstimateJournal const& journal,
                           JudgedErrors const& errors, std::vector<SettingData> const& settings,
                           std::vector<MethodData> const& methods) {
    constexpr double right_m = 0.02;
    std::string text =
        "| setting | method | found | of them below 2 cm | others | of them below 2 cm |\n"
        "| --- | --- | --- | --- | --- | --- |\n";
    for (SettingData const& setting : settings)
        for (MethodData const& method : methods) {
            std::array<std::size_t, 2> all{}, right{};  // found, others
            for_each_result(wanted, journal, setting, method,
                            [&](WantedEstimate const& each, experiments::EstimateResult const& result) {
                                std::size_t const verdict = result.verdict == "found" ? 0 : 1;
                                std::optional<poses::EstimateErrors> const off = errors.of(each);
                                ++all[verdict];
                                right[verdict] += off && off->add_s_m < right_m ? 1U : 0U;
                            });
            fmt::format_to(std::back_inserter(text), "| {} | {} | {} | {} | {} | {} |\n", setting.name, method.name,
                           all[0], right[0], all[1], right[1]);
        }
    return text;
}

/// Makes the scenes of an experiment file, looks for every object with every method, and judges what came out. Goes on
/// where it was if it has been interrupted. Throws InputError on bad input. Exit code 1 if an estimate crashed.
int experiment(ExperimentRequest const& request) {
    experiments::Experiment const wish = experiments::read_experiment_file(request.file);
    std::vector<MethodData> const methods = methods_of(wish);
    fs::path const out = request.out;
    std::size_t const jobs = jobs_or_host_cores(request.jobs);
    take_folder_of_estimates(out, "an experiment");
    io::FolderLock const lock(out);
    experiments::EstimateJournal journal(out / journal_of_estimates);
    std::vector<SettingData> const settings = prepared(wish, out, jobs);
    std::vector<WantedEstimate> const wanted = wanted_estimates(settings, methods);
    EstimateWorker worker(wanted, journal);
    announce(worker.size("experiment", jobs), request.force);
    say("{} estimates, {} of them done already\n", wanted.size(), wanted.size() - worker.pending());
    std::fflush(stdout);
    worker.work(jobs, wanted.size());
    write_results(out, wanted, journal, settings, methods);
    JudgedErrors errors;
    for (SettingData const& setting : settings)
        judge(out, wanted, journal, setting, methods, jobs, request.force, errors);
    io::write_file_atomically(out / "estimates.csv", estimates_csv(wanted, journal, errors));
    std::vector<Failure> const failures = failures_among(wanted, journal, errors);
    write_failures(out, failures, settings, request.failures);
    say("\n# failures by reason\n\n{}\n# verdicts\n\n{}\nwritten: {}\n", failures_table(failures, settings, methods),
        verdicts_table(wanted, journal, errors, settings, methods), request.out);
    return worker.failed() == 0 ? exit_done : exit_failed_check;
}

}  // namespace

Subcommand experiment_command() {
    return {"experiment",
            "Look for many objects in many scenes by several methods, and judge the poses; goes on where it was",
            [](CLI::App& command) {
                auto const request = std::make_shared<ExperimentRequest>();
                command.add_option("experiment", request->file, "Experiment file (YAML)")
                    ->required()
                    ->type_name("EXPERIMENT");
                command.add_option("--out", request->out, "Folder of scenes and results")->required()->type_name("DIR");
                command
                    .add_option("--failures", request->failures,
                                "Pictures of the worst estimates of a setting, a sheet for each (8)")
                    ->type_name("N")
                    ->check(number_in(0, most_failures));
                add_jobs(command, request->jobs, "Processes at once");
                add_force(command, request->force);
                return [request] { return experiment(*request); };
            }};
}

}  // namespace faster
