#include "tb/experiment_failures.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>
#include <mutex>

#include "faster/faster_config.hpp"
#include "kernel/base/on_threads.hpp"
#include "tb/estimate_scene.hpp"
#include "tb/estimate_scorers.hpp"
#include "tool/progress_line.hpp"

namespace faster {

namespace {

constexpr double wrong_m = 0.02;
constexpr double least_overlap = 0.1;
constexpr double least_in_window = 0.9;
constexpr double least_visible = 0.1;

DetectionConfig true_box(estimation::Scene const& scene) {
    return estimation::box_around(scene.observed.posed.mesh.vertices, *scene.truth, scene.observed.posed.camera);
}

bool was_seen(estimation::Scene const& scene) {
    DetectionConfig const truth = true_box(scene);
    return std::any_of(scene.boxes.begin(), scene.boxes.end(), [&truth](DetectionConfig const& box) {
        return estimation::overlap_share(box, truth) >= least_overlap;
    });
}

/// Of the stretch [begin, begin + length), what lies in the window around `middle`.
double stretch_in_window(double begin, double length, double middle, int window) {
    int const half = window / 2;
    double const first = std::max(begin, middle - half), end = std::min(begin + length, middle + half);
    return std::max(0.0, end - first);
}

/// Of the object's box, at the true pose.
double share_in_window(estimation::Scene const& scene) {
    DetectionConfig const box = true_box(scene);
    Camera const& camera = scene.observed.posed.camera;
    Eigen::Vector3d const& middle = scene.truth->translation;
    double const area = box.width * box.height;
    double const inside =
        stretch_in_window(box.left, box.width, camera.fx * middle.x() / middle.z() + camera.cx, scene.observed.window) *
        stretch_in_window(box.top, box.height, camera.fy * middle.y() / middle.z() + camera.cy, scene.observed.window);
    return area > 0 ? inside / area : 0;
}

/// Of the pose that the scene takes for the true one.
std::optional<double> visible_share(WantedEstimate const& wanted) {
    bop::DatasetImage const& image = *wanted.setting->dataset.find(wanted.target.image);
    for (bop::GroundTruth const& object : image.objects)
        if (object.obj_id == wanted.target.obj_id)
            return object.visible_share;
    return std::nullopt;
}

FailureReason reason_of(WantedEstimate const& wanted, experiments::EstimateResult const& result,
                        estimation::Scene const& scene, PoseDistances const& off) {
    bool const has_window = estimator_of(wanted.method->loaded.config).backend == EstimatorBackend::accelerator;
    if (off.adds_m < wrong_m)
        return FailureReason::symmetry;
    if (!was_seen(scene))
        return FailureReason::box;
    if (has_window && share_in_window(scene) < least_in_window)
        return FailureReason::size;
    if (visible_share(wanted).value_or(1) < least_visible)
        return FailureReason::hidden;
    return result.weight >= result.truth_weight ? FailureReason::score : FailureReason::search;
}

std::optional<Failure> looked_at(WantedEstimate const& wanted, experiments::EstimateResult const& result) {
    estimation::Scene const scene = scene_of(wanted);
    std::optional<PoseDistances> const off = distances_from_truth(scene, scene.centred(result.pose));
    if (!off || off->add_m < wrong_m)
        return std::nullopt;
    return Failure{&wanted, &result, 1000 * off->add_m, 1000 * off->adds_m, reason_of(wanted, result, scene, *off)};
}

}  // namespace

std::vector<Failure> failures_among(std::vector<WantedEstimate> const& wanted,
                                    experiments::EstimateJournal const& journal, std::size_t jobs) {
    std::vector<std::optional<Failure>> found(wanted.size());
    ProgressLine progress("estimates looked at");
    std::mutex mutex;
    std::size_t done = 0;
    on_threads(wanted.size(), jobs, [&](std::size_t i) {
        if (experiments::EstimateResult const* const result = journal.find(wanted[i].id))
            found[i] = looked_at(wanted[i], *result);
        std::lock_guard<std::mutex> const lock(mutex);
        progress.show(++done, wanted.size());
    });
    std::vector<Failure> failures;
    for (std::optional<Failure> const& each : found)
        if (each)
            failures.push_back(*each);
    return failures;
}

std::string failures_csv(std::vector<Failure> const& failures) {
    std::string text = "setting,method,scene_id,im_id,obj_id,visible_share,weight,truth_weight,add_mm,adds_mm,reason\n";
    for (Failure const& each : failures) {
        WantedEstimate const& wanted = *each.wanted;
        std::optional<double> const visible = visible_share(wanted);
        fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{:.6f},{:.6f},{:.4f},{:.4f},{}\n",
                       wanted.setting->name, wanted.method->name, wanted.target.image.scene_id,
                       wanted.target.image.im_id, wanted.target.obj_id, visible ? fmt::format("{:.4f}", *visible) : "",
                       each.result->weight, each.result->truth_weight, each.add_mm, each.adds_mm, each.reason_name());
    }
    return text;
}

std::string failures_table(std::vector<Failure> const& failures, std::vector<SettingData> const& settings,
                           std::vector<MethodData> const& methods) {
    std::string text = "| setting | method |", rule = "\n| --- | --- |";
    for (char const* const reason : failure_reasons) {
        text += fmt::format(" {} |", reason);
        rule += " --- |";
    }
    text += rule + "\n";
    for (SettingData const& setting : settings)
        for (MethodData const& method : methods) {
            std::array<std::size_t, failure_reasons.size()> counts{};
            for (Failure const& each : failures)
                if (each.wanted->setting == &setting && each.wanted->method == &method)
                    ++counts[static_cast<std::size_t>(each.reason)];
            text += fmt::format("| {} | {} |", setting.name, method.name);
            for (std::size_t const count : counts)
                text += fmt::format(" {} |", count);
            text += "\n";
        }
    return text;
}

}  // namespace faster
