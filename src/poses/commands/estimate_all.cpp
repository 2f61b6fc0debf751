#include "poses/commands/estimate_all.hpp"

#include <algorithm>
#include <cstdio>
#include <deque>
#include <filesystem>
#include <fmt/format.h>
#include <map>
#include <vector>

#include "dataflow/base/files/folder_lock.hpp"
#include "dataflow/base/files/output_file.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/base/on_threads.hpp"
#include "dataflow/commands/exit_codes.hpp"
#include "dataflow/commands/say.hpp"
#include "faster/config/faster_config.hpp"
#include "faster/dataflow_names.hpp"
#include "poses/bop/read_dataset.hpp"
#include "poses/commands/estimate_scorers.hpp"
#include "poses/commands/estimate_worker.hpp"
#include "poses/commands/experiment_estimates.hpp"
#include "poses/experiments/estimate_journal.hpp"
#include "poses/judging/counted_poses.hpp"

namespace faster {
namespace {

/// The detector's boxes of targets, or the annotated ones of what is visible, with the configured confidence.
class TargetBoxes {
  public:
    TargetBoxes(SettingData& data, double confidence) : data_(data), confidence_(confidence) {}

    void add_detected(std::string const& file) {
        for (bop::Detection const& detection : bop::read_detections(file, warnings_))
            detected_[{detection.image, detection.obj_id}].push_back(&kept_.emplace_back(detection));
        if (data_.dataset.targets.empty())
            add_detected_targets();
        for (bop::Target const& target : data_.dataset.targets)
            for (bop::Detection const* const detection : detected_[{target.image, target.obj_id}])
                add(target, bop::sound(*detection));
        if (boxes_outside_ > 0)
            warnings_.push_back(fmt::format("{}: boxes outside of their images are left out: {}, such as {}", file,
                                            boxes_outside_, outside_));
    }

    /// A camera's unit is the same all over a dataset, so one image tells.
    void look_at_depths() {
        if (!data_.dataset.targets.empty()) {
            bop::DatasetImage const& image = *data_.dataset.find(data_.dataset.targets.front().image);
            bop::tell_of_depths(bop::load_observation(image), image, warnings_);
        }
    }

    void add_annotated() {
        for (bop::Target const& target : data_.dataset.targets) {
            bop::DatasetImage const& image = bop::sound(*data_.dataset.find(target.image));
            for (bop::Detection& box : annotated_boxes(
                     poses::most_visible(data_.dataset, target), image.id, image.camera,
                     [this](int obj_id) -> Mesh const& { return mesh(obj_id); }, confidence_))
                data_.boxes[{target.image, target.obj_id}].push_back(std::move(box));
        }
    }

    /// A mesh that cannot be read is the business of the estimates that need it.
    void look_at_models() {
        for (bop::Target const& target : data_.dataset.targets) {
            try {
                mesh(target.obj_id);
            } catch (InputError const&) {
            }
        }
    }

    std::vector<std::string> const& warnings() const { return warnings_; }

  private:
    /// Where nobody has annotated anything, what a detector saw is to be found: once, as nobody says how often.
    void add_detected_targets() {
        for (auto const& [seen, boxes] : detected_)
            if (data_.dataset.find(seen.first) != nullptr)
                data_.dataset.targets.push_back({seen.first, seen.second, 1});
    }

    void add(bop::Target const& target, bop::Detection const& detection) {
        bop::ImageBox const& box = detection.box;
        if (overlaps(box, camera(target.image))) {
            data_.boxes[{target.image, target.obj_id}].push_back(detection);
            return;
        }
        ++boxes_outside_;
        outside_ = fmt::format("[{}, {}, {}, {}] in image {} of scene {}", box.left, box.top, box.width, box.height,
                               target.image.im_id, target.image.scene_id);
    }

    /// With the size of the image itself: what camera.json says is meant for others.
    Camera const& camera(bop::ImageId id) {
        auto const [found, is_new] = cameras_.try_emplace(id);
        if (is_new)
            found->second = bop::load_observation(*data_.dataset.find(id)).camera;
        return found->second;
    }

    Mesh const& mesh(int obj_id) {
        auto const [found, is_new] = meshes_.try_emplace(obj_id);
        if (is_new)
            found->second =
                bop::load_model(bop::model_of(data_.dataset, obj_id, data_.dataset.place_of_targets()), warnings_);
        return found->second;
    }

    SettingData& data_;
    double confidence_;
    std::deque<bop::Detection> kept_;
    std::map<std::pair<bop::ImageId, int>, std::vector<bop::Detection const*>> detected_;
    std::map<bop::ImageId, Camera> cameras_;
    std::map<int, Mesh> meshes_;
    std::size_t boxes_outside_ = 0;
    std::string outside_;  // the last of them
    std::vector<std::string> warnings_;
};

/// An object that nobody detected is not looked for.
std::size_t leave_out_undetected(SettingData& data) {
    std::vector<bop::Target>& targets = data.dataset.targets;
    std::size_t const before = targets.size();
    targets.erase(std::remove_if(targets.begin(), targets.end(),
                                 [&](bop::Target const& target) { return data.boxes_of(target).empty(); }),
                  targets.end());
    return before - targets.size();
}

SettingData prepared_data(EstimateAllRequest const& request, LoadedConfig const& loaded) {
    SettingData data;
    data.name = request.bop.folder;
    data.dataset = dataset_of(request.bop);
    TargetBoxes boxes(data, estimator_of(loaded.config).box.confidence);
    if (request.bop.detections.empty())
        boxes.add_annotated();
    else
        boxes.add_detected(request.bop.detections);
    boxes.look_at_models();
    boxes.look_at_depths();
    say_warnings(data.dataset.warnings);
    say_warnings(data.dataset.warnings_of_targets);
    say_warnings(boxes.warnings());
    return data;
}

}  // namespace

int estimate_all(EstimateAllRequest const& request, LoadedConfig const& loaded) {
    require_estimable(loaded);
    say_warnings(idle_keys_of_datasets(loaded));
    std::filesystem::path const out = request.out;
    std::size_t const jobs = jobs_or_host_cores(request.jobs);
    std::vector<SettingData> settings{prepared_data(request, loaded)};
    std::size_t const targets = settings[0].dataset.targets.size(), undetected = leave_out_undetected(settings[0]);
    if (targets == 0)
        throw InputError(request.bop.folder +
                         ": has no targets, expected some: annotated objects (scene_gt.json, frames.json), rows of "
                         "test_targets_bop19.json, or --detections in its images");
    if (targets == undetected)
        throw InputError(fmt::format("{}: has a box for none of the {} targets of {}, expected some",
                                     request.bop.detections.empty() ? request.bop.folder : request.bop.detections,
                                     targets, request.bop.folder));
    std::vector<MethodData> const methods{{scorer_name(loaded.config), loaded}};
    std::vector<WantedEstimate> const wanted = wanted_estimates(settings, methods);
    take_folder_of_estimates(out, "an estimate of all");
    io::FolderLock const lock(out);
    experiments::EstimateJournal journal(out / journal_of_estimates);
    EstimateWorker worker(wanted, journal);
    announce(worker.size("estimate", jobs), request.force);
    say("{} targets, {} without a box; {} estimates, {} of them done already\n", targets, undetected, wanted.size(),
        wanted.size() - worker.pending());
    std::fflush(stdout);
    worker.work(jobs, wanted.size());
    io::write_file_atomically(out / "results.csv", results_of(wanted, journal, settings[0], methods[0]));
    say("written: {}\n", (out / "results.csv").string());
    return worker.failed() == 0 ? exit_done : exit_failed_check;
}

}  // namespace faster
