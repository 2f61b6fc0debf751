#include "poses/judging/counted_poses.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "dataflow/base/input_error.hpp"
#include "dataflow/base/middle_of.hpp"
#include "faster/dataflow_names.hpp"
#include "poses/bop/read_dataset.hpp"

namespace faster::poses {

namespace {

/// Where an estimate stands, and what it is of.
std::string place_of(bop::PoseEstimate const& estimate, std::filesystem::path const& file) {
    return fmt::format("{}:{}: scene_id, im_id, obj_id = {}, {}, {}", file.string(), estimate.line,
                       estimate.image.scene_id, estimate.image.im_id, estimate.obj_id);
}

Truths truths_of(bop::Dataset const& dataset, bop::Target const& target) {
    Truths truths;
    for (bop::GroundTruth const& object : dataset.find(target.image)->objects) {
        if (object.obj_id == target.obj_id)
            truths.push_back(&bop::sound(object));
    }
    return truths;
}

}  // namespace

EstimatesByTarget::EstimatesByTarget(bop::Dataset const& dataset, std::vector<bop::PoseEstimate> const& estimates,
                                     std::filesystem::path const& file, std::vector<std::string>& warnings)
    : dataset_(dataset), file_(file) {
    for (bop::Target const& target : dataset.targets)
        groups_[{target.image, target.obj_id}];
    for (bop::PoseEstimate const& estimate : estimates)
        sort_in(estimate);
    require_some(estimates);
    for (auto& [name, group] : groups_)
        std::stable_sort(group.begin(), group.end(), [](auto const* a, auto const* b) { return a->score > b->score; });
    tell(estimates.size(), warnings);
}

Estimates EstimatesByTarget::best(bop::Target const& target) const {
    auto const found = groups_.find({target.image, target.obj_id});
    if (found == groups_.end())
        return {};
    auto const count = std::min(found->second.size(), static_cast<std::size_t>(target.inst_count));
    return {found->second.begin(), found->second.begin() + static_cast<std::ptrdiff_t>(count)};
}

void EstimatesByTarget::sort_in(bop::PoseEstimate const& estimate) {
    auto const group = groups_.find({estimate.image, estimate.obj_id});
    if (group != groups_.end()) {
        group->second.push_back(&bop::sound(estimate));
        ++taken_;
    } else if (dataset_.find(estimate.image) == nullptr || dataset_.models.count(estimate.obj_id) == 0) {
        first_unknown_ = unknown_++ == 0 ? place_of(estimate, file_) : first_unknown_;
    }
}

void EstimatesByTarget::require_some(std::vector<bop::PoseEstimate> const& estimates) const {
    if (taken_ == 0 && !estimates.empty() && !dataset_.targets.empty()) {
        bop::Target const& target = dataset_.targets.front();
        throw InputError(fmt::format("{}, and no row of the {} is of a target of {}, expected rows such as {}, {}, {}",
                                     place_of(estimates.front(), file_), estimates.size(), dataset_.folder.string(),
                                     target.image.scene_id, target.image.im_id, target.obj_id));
    }
}

void EstimatesByTarget::tell(std::size_t rows, std::vector<std::string>& warnings) const {
    if (unknown_ > 0)
        warnings.push_back(fmt::format("{}, which {} does not have; {} of {} rows are left out for that",
                                       first_unknown_, dataset_.folder.string(), unknown_, rows));
}

void EstimatesByTarget::tell_of_unit(std::vector<std::string>& warnings) const {
    constexpr double too_much = 100, mm_per_m = 1000;
    std::vector<double> estimated, annotated;
    for (auto const& [name, group] : groups_) {
        for (bop::PoseEstimate const* const estimate : group)
            estimated.push_back(mm_per_m * estimate->pose.translation.norm());
        for (bop::GroundTruth const* const truth : truths_of(dataset_, {name.first, name.second, 1}))
            annotated.push_back(mm_per_m * truth->pose.translation.norm());
    }
    if (estimated.empty() || annotated.empty())
        return;
    double const found = middle_of(estimated), expected = middle_of(annotated);
    if (found * too_much < expected || found > expected * too_much)
        warnings.push_back(
            fmt::format("{}: column t puts half of the objects within {:.3g} mm, the true poses within {:.3g} mm: t is "
                        "in millimetres",
                        file_.string(), found, expected));
}

Truths most_visible(bop::Dataset const& dataset, bop::Target const& target) {
    Truths truths = truths_of(dataset, target);
    std::stable_sort(truths.begin(), truths.end(), [](auto const* a, auto const* b) {
        return a->visible_share.value_or(1) > b->visible_share.value_or(1);
    });
    truths.resize(std::min(truths.size(), static_cast<std::size_t>(target.inst_count)));
    return truths;
}

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

}  // namespace faster::poses
