#include "poses/judging/judge.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <map>
#include <numeric>
#include <set>

#include "dataflow/base/counted_progress.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/base/on_threads.hpp"
#include "dataflow/base/random.hpp"
#include "faster/dataflow_names.hpp"
#include "poses/bop/read_dataset.hpp"
#include "poses/judging/mesh_symmetries.hpp"
#include "poses/judging/pose_error.hpp"
#include "poses/judging/visible_surface.hpp"

namespace faster::poses {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

class Matching {
  public:
    Matching(PairErrors const& errors, std::size_t truths)
        : errors_(errors), is_used_(errors.size(), false), matched_(truths, infinite) {}

    void match(double limit) {
        for (std::size_t e = 0; e < errors_.size(); ++e) {
            if (!is_used_[e])
                take_nearest(e, limit);
        }
    }
    std::vector<double> const& errors() const { return matched_; }

  private:
    void take_nearest(std::size_t e, double limit) {
        std::size_t nearest = matched_.size();
        for (std::size_t g = 0; g < matched_.size(); ++g) {
            double const least = nearest < matched_.size() ? errors_[e][nearest] : limit;
            if (matched_[g] == infinite && errors_[e][g] < least)
                nearest = g;
        }
        if (nearest < matched_.size()) {
            matched_[nearest] = errors_[e][nearest];
            is_used_[e] = true;
        }
    }

    PairErrors const& errors_;
    std::vector<bool> is_used_;
    std::vector<double> matched_;
};

constexpr double pi = Random::pi;
constexpr int steps_per_turn = 315;  // ceil(pi / 0.01)

/// The i-th turn about an axis.
Pose turn(bop::ObjectModel::Axis const& axis, int i) {
    Pose pose;
    pose.rotation = Eigen::AngleAxisd(i * (2 * pi / steps_per_turn), axis.direction).toRotationMatrix();
    pose.translation = axis.offset - pose.rotation * axis.offset;
    return pose;
}

/// The identity, and every turn about every axis.
std::vector<Pose> turns_of(bop::ObjectModel const& model) {
    std::vector<Pose> turns{Pose{}};
    for (bop::ObjectModel::Axis const& axis : model.axes) {
        for (int i = 1; i < steps_per_turn; ++i)
            turns.push_back(turn(axis, i));
    }
    return turns;
}

/// Up to 0.1 m, inclusive.
double const add_limit_m = std::nextafter(largest_add_m, 1.0);

/// What a model's errors are worked out with.
struct JudgedModel {
    Mesh mesh;
    std::vector<Pose> symmetries;
    double diameter_m = 0;
};

using Models = std::map<int, JudgedModel>;
using Estimates = std::vector<bop::PoseEstimate const*>;
using Truths = std::vector<bop::GroundTruth const*>;
using TargetName = std::pair<bop::ImageId, int>;

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
        bop::model_of(dataset, target.obj_id, dataset.folder.string());
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

/// Where an estimate stands, and what it is of.
std::string place_of(bop::PoseEstimate const& estimate, std::filesystem::path const& file) {
    return fmt::format("{}:{}: scene_id, im_id, obj_id = {}, {}, {}", file.string(), estimate.line,
                       estimate.image.scene_id, estimate.image.im_id, estimate.obj_id);
}

/// Estimates by target, the best score first; of equal scores the one that stands first.
class EstimatesByTarget {
  public:
    EstimatesByTarget(bop::Dataset const& dataset, std::vector<bop::PoseEstimate> const& estimates,
                      std::filesystem::path const& file, std::vector<std::string>& warnings)
        : dataset_(dataset), file_(file) {
        for (bop::Target const& target : dataset.targets)
            groups_[{target.image, target.obj_id}];
        for (bop::PoseEstimate const& estimate : estimates)
            sort_in(estimate);
        require_some(estimates);
        for (auto& [name, group] : groups_)
            std::stable_sort(group.begin(), group.end(),
                             [](auto const* a, auto const* b) { return a->score > b->score; });
        tell(estimates.size(), warnings);
    }

    std::map<TargetName, Estimates> const& groups() const { return groups_; }

  private:
    void sort_in(bop::PoseEstimate const& estimate) {
        auto const group = groups_.find({estimate.image, estimate.obj_id});
        if (group != groups_.end()) {
            group->second.push_back(&bop::sound(estimate));
            ++taken_;
        } else if (dataset_.find(estimate.image) == nullptr || dataset_.models.count(estimate.obj_id) == 0) {
            first_unknown_ = unknown_++ == 0 ? place_of(estimate, file_) : first_unknown_;
        }
    }

    void require_some(std::vector<bop::PoseEstimate> const& estimates) const {
        if (taken_ == 0 && !estimates.empty() && !dataset_.targets.empty()) {
            bop::Target const& target = dataset_.targets.front();
            throw InputError(
                fmt::format("{}, and no row of the {} is of a target of {}, expected rows such as {}, {}, {}",
                            place_of(estimates.front(), file_), estimates.size(), dataset_.folder.string(),
                            target.image.scene_id, target.image.im_id, target.obj_id));
        }
    }

    void tell(std::size_t rows, std::vector<std::string>& warnings) const {
        if (unknown_ > 0)
            warnings.push_back(fmt::format("{}, which {} does not have; {} of {} rows are left out for that",
                                           first_unknown_, dataset_.folder.string(), unknown_, rows));
    }

    bop::Dataset const& dataset_;
    std::filesystem::path const& file_;
    std::map<TargetName, Estimates> groups_;
    std::size_t taken_ = 0, unknown_ = 0;
    std::string first_unknown_;
};

Estimates best(std::map<TargetName, Estimates> const& groups, bop::Target const& target) {
    auto const found = groups.find({target.image, target.obj_id});
    if (found == groups.end())
        return {};
    auto const count = std::min(found->second.size(), static_cast<std::size_t>(target.inst_count));
    return {found->second.begin(), found->second.begin() + static_cast<std::ptrdiff_t>(count)};
}

Truths truths_of(bop::Dataset const& dataset, bop::Target const& target) {
    Truths truths;
    for (bop::GroundTruth const& object : dataset.find(target.image)->objects) {
        if (object.obj_id == target.obj_id)
            truths.push_back(&bop::sound(object));
    }
    return truths;
}

/// The most visible ones, in the order of the file; as many as there are to be found.
Truths most_visible(bop::Dataset const& dataset, bop::Target const& target) {
    Truths truths = truths_of(dataset, target);
    std::stable_sort(truths.begin(), truths.end(), [](auto const* a, auto const* b) {
        return a->visible_share.value_or(0) > b->visible_share.value_or(0);
    });
    truths.resize(std::min(truths.size(), static_cast<std::size_t>(target.inst_count)));
    return truths;
}

/// Targets may ask for more than has been annotated.
void tell_of_missing_truths(bop::Dataset const& dataset, std::vector<std::string>& warnings) {
    std::size_t missing = 0, asked = 0;
    std::string first;
    for (bop::Target const& target : dataset.targets) {
        std::size_t const there = truths_of(dataset, target).size(),
                          count = static_cast<std::size_t>(target.inst_count);
        asked += count;
        if (there >= count)
            continue;
        missing += count - there;
        if (first.empty())
            first = fmt::format("{}: scene {}, image {} has object {} {} times, expected {} as the targets say",
                                dataset.folder.string(), target.image.scene_id, target.image.im_id, target.obj_id,
                                there, count);
    }
    if (missing > 0)
        warnings.push_back(
            fmt::format("{}; {} of {} instances have no true pose, and are not counted", first, missing, asked));
}

double median(std::vector<double> values) {
    auto const middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Half of the estimates are a hundred times as near as half of the true poses are, or as far.
void tell_of_unit(bop::Dataset const& dataset, std::map<TargetName, Estimates> const& groups,
                  std::filesystem::path const& file, std::vector<std::string>& warnings) {
    constexpr double too_much = 100, mm_per_m = 1000;
    std::vector<double> estimated, annotated;
    for (auto const& [name, group] : groups) {
        for (bop::PoseEstimate const* const estimate : group)
            estimated.push_back(mm_per_m * estimate->pose.translation.norm());
        for (bop::GroundTruth const* const truth : truths_of(dataset, {name.first, name.second, 1}))
            annotated.push_back(mm_per_m * truth->pose.translation.norm());
    }
    if (estimated.empty() || annotated.empty())
        return;
    double const found = median(estimated), expected = median(annotated);
    if (found * too_much < expected || found > expected * too_much)
        warnings.push_back(
            fmt::format("{}: column t puts half of the objects within {:.3g} mm, the true poses within {:.3g} mm: t is "
                        "in millimetres",
                        file.string(), found, expected));
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
        if (image.problem.empty() && std::filesystem::exists(image.depth, ignored)) {
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
        : estimates_(estimates), truths_(truths), model_(model) {}

    std::vector<InstanceErrors> errors(bop::Target const& target, JudgedImage const& image, double vsd_delta_m) const {
        Points const& points = model_.mesh.vertices;
        std::size_t const n = truths_.size();
        auto const adds =
            matched(by_pose([&](auto const& e, auto const& t) { return add(points, e, t); }), n, add_limit_m);
        auto const adds_s =
            matched(by_pose([&](auto const& e, auto const& t) { return add_s(points, e, t); }), n, add_limit_m);
        PairErrors const mssds =
            by_pose([&](auto const& e, auto const& t) { return mssd(points, model_.symmetries, e, t); });
        PairErrors const mspds = by_pose([&](auto const& e, auto const& t) {
            return image.pixel_scale() * mspd(points, model_.symmetries, e, t, image.camera);
        });
        auto const largest = matched(mssds, n, recall_step * recall_thresholds * model_.diameter_m);
        auto const largest_px = matched(mspds, n, recall_step_px * recall_thresholds);
        auto const found = hits(mssds, n, recall_step * model_.diameter_m), found_px = hits(mspds, n, recall_step_px);
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

std::vector<double> matched_below(PairErrors const& errors, std::size_t truths, double limit) {
    Matching matching(errors, truths);
    matching.match(limit);
    return matching.errors();
}

std::vector<double> matched(PairErrors const& errors, std::size_t truths, double limit) {
    Matching matching(errors, truths);
    matching.match(limit);
    matching.match(infinite);
    return matching.errors();
}

std::vector<Pose> symmetries_of(bop::ObjectModel const& model) {
    std::vector<Pose> discrete{Pose{}};
    discrete.insert(discrete.end(), model.symmetries.begin(), model.symmetries.end());
    std::vector<Pose> const turns = turns_of(model);
    std::vector<Pose> all;
    for (Pose const& symmetry : discrete) {
        for (Pose const& then : turns)
            all.push_back({then.rotation * symmetry.rotation, then.rotation * symmetry.translation + then.translation});
    }
    return all;
}

Judgement judge(bop::Dataset const& dataset, std::vector<bop::PoseEstimate> const& estimates,
                std::filesystem::path const& file, JudgeOptions const& options,
                std::function<void(std::size_t done, std::size_t all)> const& progress) {
    Judgement judgement;
    EstimatesByTarget const sorted(dataset, estimates, file, judgement.warnings);
    auto const& groups = sorted.groups();
    Models const models = load_models(dataset, options.jobs, judgement.warnings);
    tell_of_missing_truths(dataset, judgement.warnings);
    tell_of_unit(dataset, groups, file, judgement.warnings);
    std::vector<std::vector<InstanceErrors>> errors(dataset.targets.size());
    std::vector<std::size_t> used(dataset.targets.size(), 0);
    std::vector<TargetRange> const ranges = by_image(dataset.targets);
    CountedProgress done(dataset.targets.size(), progress);
    on_threads(ranges.size(), options.jobs, [&](std::size_t range) {
        JudgedImage const image(*dataset.find(dataset.targets[ranges[range].begin].image));
        for (std::size_t i = ranges[range].begin; i < ranges[range].end; ++i) {
            bop::Target const& target = dataset.targets[i];
            Estimates const counted = best(groups, target);
            used[i] = counted.size();
            Truths const truths = most_visible(dataset, target);
            errors[i] =
                TargetJudge(counted, truths, models.at(target.obj_id)).errors(target, image, options.vsd_delta_m);
            done.one_more();
        }
    });
    judgement.left_out = estimates.size() - std::accumulate(used.begin(), used.end(), std::size_t{0});
    for (auto const& of_target : errors)
        judgement.instances.insert(judgement.instances.end(), of_target.begin(), of_target.end());
    return judgement;
}

}  // namespace faster::poses
