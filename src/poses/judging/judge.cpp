#include "poses/judging/judge.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

#include "dataflow/base/counted_progress.hpp"
#include "dataflow/base/on_threads.hpp"
#include "faster/data/mesh_size.hpp"
#include "faster/dataflow_names.hpp"
#include "poses/bop/read_dataset.hpp"
#include "poses/judging/counted_poses.hpp"
#include "poses/judging/depth_images.hpp"
#include "poses/judging/matching.hpp"
#include "poses/judging/mesh_symmetries.hpp"
#include "poses/judging/model_symmetries.hpp"
#include "poses/judging/pose_error.hpp"
#include "poses/judging/visible_surface.hpp"

namespace faster::poses {

namespace {

/// Up to 0.1 m, inclusive.
double const add_limit_m = std::nextafter(largest_add_m, 1.0);

/// What a model's errors are worked out with.
struct JudgedModel {
    Mesh mesh;
    std::vector<Pose> symmetries;
    double diameter_m = 0;
};

using Models = std::map<int, JudgedModel>;

JudgedModel judged_model(bop::ObjectModel const& model, Mesh&& mesh) {
    JudgedModel judged;
    judged.mesh = std::move(mesh);
    judged.symmetries =
        model.info.empty() ? symmetries_of(with_symmetries_of_mesh(model, judged.mesh)) : symmetries_of(model);
    judged.diameter_m = model.diameter_m ? *model.diameter_m : diameter_of(judged.mesh.vertices);
    return judged;
}

/// The models that targets are of.
Models load_models(bop::Dataset const& dataset, std::size_t jobs, std::vector<std::string>& warnings) {
    Models models;
    for (bop::Target const& target : dataset.targets) {
        bop::model_of(dataset, target.obj_id, dataset.place_of_targets());
        models[target.obj_id];
    }
    std::vector<Models::value_type*> entries;
    std::vector<bop::ObjectModel const*> files;
    for (auto& entry : models) {
        entries.push_back(&entry);
        files.push_back(&dataset.models.at(entry.first));
    }
    std::vector<Mesh> meshes = bop::load_models(files, jobs, warnings);  // in processes, which threads do not go with
    on_threads(entries.size(), jobs,
               [&](std::size_t i) { entries[i]->second = judged_model(*files[i], std::move(meshes[i])); });
    return models;
}

template <class Error> PairErrors pairs(Estimates const& estimates, Truths const& truths, Error const& error) {
    PairErrors errors;
    for (auto const* estimate : estimates) {
        errors.emplace_back();
        for (auto const* truth : truths)
            errors.back().push_back(error(estimate->pose, truth->pose));
    }
    return errors;
}

std::vector<int> hits(PairErrors const& errors, std::size_t truths, double step) {
    std::vector<int> hits(truths, 0);
    for (int threshold = 1; threshold <= recall_thresholds; ++threshold) {
        auto const found = matched_below(errors, truths, step * threshold);
        for (std::size_t g = 0; g < truths; ++g)
            hits[g] += std::isfinite(found[g]) ? 1 : 0;
    }
    return hits;
}

/// The image of a target, and what its camera saw, if that is at hand.
struct JudgedImage {
    JudgedImage(bop::DatasetImage const& image) : camera(image.camera) {
        std::error_code ignored;
        if (std::filesystem::exists(image.depth, ignored)) {
            bop::Observation const observation = bop::load_observation(image);
            camera = observation.camera;
            seen = seen_distances(observation);
        } else if (camera.width == 0) {
            camera.width = static_cast<int>(2 * camera.cx + 1);
        }
    }
    /// BOP's thresholds are those of images of 640 pixels' width.
    double pixel_scale() const { return 640.0 / std::max(1, camera.width); }

    Camera camera;
    std::optional<DistanceImage> seen;
};

/// Judges the estimates of a target.
class TargetJudge {
  public:
    TargetJudge(Estimates const& estimates, Truths const& truths, JudgedModel const& model)
        : estimates_(estimates),
          truths_(truths),
          model_(model),
          adds_(by_pose([&](auto const& e, auto const& t) { return add(model_.mesh.vertices, e, t); })),
          adds_s_(by_pose([&](auto const& e, auto const& t) { return add_s(model_.mesh.vertices, e, t); })),
          mssds_(by_pose(
              [&](auto const& e, auto const& t) { return mssd(model_.mesh.vertices, model_.symmetries, e, t); })) {}

    std::vector<EstimateErrors> nearest() const {
        std::vector<EstimateErrors> errors;
        for (std::size_t e = 0; e < estimates_.size() && !truths_.empty(); ++e)
            errors.push_back({estimates_[e]->line, least(adds_[e]), least(adds_s_[e]), least(mssds_[e])});
        return errors;
    }

    std::vector<InstanceErrors> errors(bop::Target const& target, JudgedImage const& image, double vsd_delta_m) const {
        std::size_t const n = truths_.size();
        auto const adds = matched(adds_, n, add_limit_m), adds_s = matched(adds_s_, n, add_limit_m);
        PairErrors const mspds = by_pose([&](auto const& e, auto const& t) {
            return image.pixel_scale() * mspd(model_.mesh.vertices, model_.symmetries, e, t, image.camera);
        });
        auto const largest = matched(mssds_, n, recall_step * recall_thresholds * model_.diameter_m);
        auto const largest_px = matched(mspds, n, recall_step_px * recall_thresholds);
        auto const found = hits(mssds_, n, recall_step * model_.diameter_m), found_px = hits(mspds, n, recall_step_px);
        std::vector<InstanceErrors> errors;
        for (std::size_t g = 0; g < n; ++g)
            errors.push_back({target.image, target.obj_id, truths_[g]->visible_share, adds[g], adds_s[g], largest[g],
                              found[g], largest_px[g], found_px[g], std::nullopt});
        if (image.seen)
            add_vsd(image, vsd_delta_m, errors);
        return errors;
    }

  private:
    static constexpr double recall_step = 0.05, recall_step_px = 5;

    static double least(std::vector<double> const& errors) { return *std::min_element(errors.begin(), errors.end()); }

    template <class Error> PairErrors by_pose(Error const& error) const { return pairs(estimates_, truths_, error); }

    template <class Item>
    std::vector<DistanceImage> drawn(std::vector<Item const*> const& items, Camera const& camera) const {
        std::vector<DistanceImage> images;
        images.reserve(items.size());
        for (Item const* const item : items)
            images.push_back(drawn_distances(model_.mesh, item->pose, camera));
        return images;
    }

    void add_vsd(JudgedImage const& image, double delta_m, std::vector<InstanceErrors>& errors) const {
        auto const estimates = drawn(estimates_, image.camera), truths = drawn(truths_, image.camera);
        std::array<PairErrors, vsd_tolerances> by_tolerance;
        for (DistanceImage const& estimate : estimates) {
            for (PairErrors& pair_errors : by_tolerance)
                pair_errors.emplace_back();
            for (DistanceImage const& truth : truths) {
                auto const each = vsd(*image.seen, estimate, truth, delta_m, model_.diameter_m);
                for (std::size_t i = 0; i < vsd_tolerances; ++i)
                    by_tolerance[i].back().push_back(each[i]);
            }
        }
        for (InstanceErrors& instance : errors)
            instance.vsd_recall = 0;
        for (PairErrors const& pair_errors : by_tolerance) {
            auto const found = hits(pair_errors, errors.size(), recall_step);
            for (std::size_t g = 0; g < errors.size(); ++g)
                *errors[g].vsd_recall += found[g] / (1.0 * recall_thresholds * vsd_tolerances);
        }
    }

    Estimates const& estimates_;
    Truths const& truths_;
    JudgedModel const& model_;
    PairErrors adds_, adds_s_, mssds_;
};

/// Targets of one image: their numbers.
struct TargetRange {
    std::size_t begin = 0, end = 0;
};

std::vector<TargetRange> by_image(std::vector<bop::Target> const& targets) {
    std::vector<TargetRange> ranges;
    for (std::size_t i = 0; i < targets.size(); ++i) {
        if (i == 0 || !(targets[i].image == targets[i - 1].image))
            ranges.push_back({i, i});
        ++ranges.back().end;
    }
    return ranges;
}

}  // namespace

Judgement judge(bop::Dataset const& dataset, std::vector<bop::PoseEstimate> const& estimates,
                std::filesystem::path const& file, JudgeOptions const& options,
                std::function<void(std::size_t done, std::size_t all)> const& progress) {
    Judgement judgement;
    EstimatesByTarget const sorted(dataset, estimates, file, judgement.warnings);
    Models const models = load_models(dataset, options.jobs, judgement.warnings);
    tell_of_missing_truths(dataset, judgement.warnings);
    sorted.tell_of_unit(judgement.warnings);
    std::vector<std::vector<InstanceErrors>> errors(dataset.targets.size());
    std::vector<std::vector<EstimateErrors>> of_estimates(dataset.targets.size());
    std::vector<std::size_t> used(dataset.targets.size(), 0);
    std::vector<TargetRange> const ranges = by_image(dataset.targets);
    std::vector<bop::DatasetImage const*> images;
    images.reserve(ranges.size());
    for (TargetRange const& range : ranges)
        images.push_back(&bop::sound(*dataset.find(dataset.targets[range.begin].image)));
    DepthImages depths(images);
    depths.tell_of_missing(judgement.warnings);
    CountedProgress done(dataset.targets.size(), progress);
    on_threads(ranges.size(), options.jobs, [&](std::size_t range) {
        JudgedImage const image(*images[range]);
        if (image.seen)
            depths.set_size(range, image.camera);
        for (std::size_t i = ranges[range].begin; i < ranges[range].end; ++i) {
            bop::Target const& target = dataset.targets[i];
            Estimates const counted = sorted.best(target);
            used[i] = counted.size();
            Truths const truths = most_visible(dataset, target);
            TargetJudge const target_judge(counted, truths, models.at(target.obj_id));
            errors[i] = target_judge.errors(target, image, options.vsd_delta_m);
            of_estimates[i] = target_judge.nearest();
            done.one_more();
        }
    });
    depths.tell_of_sizes(judgement.warnings);
    judgement.left_out = estimates.size() - std::accumulate(used.begin(), used.end(), std::size_t{0});
    for (auto const& of_target : errors)
        judgement.instances.insert(judgement.instances.end(), of_target.begin(), of_target.end());
    for (auto const& of_target : of_estimates)
        judgement.estimates.insert(judgement.estimates.end(), of_target.begin(), of_target.end());
    return judgement;
}

}  // namespace faster::poses
