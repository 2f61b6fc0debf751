#include "poses/commands/experiment_failures.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <map>

#include "dataflow/commands/progress_line.hpp"
#include "faster/config/faster_config.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/workload/pictures/colour.hpp"
#include "faster/workload/pictures/convergence_sheet.hpp"
#include "faster/workload/scene_renderer.hpp"
#include "poses/commands/estimate_scene.hpp"
#include "poses/commands/estimate_scorers.hpp"

namespace faster {

namespace {

constexpr Colour true_outline{0, 130, 60};
constexpr int least_side = 200;  // of a picture; they fill a cell when doubled

/// A square part of the image, which it may leave.
struct Part {
    int top = 0;
    int left = 0;
    int side = 0;
};

Part part_around(DetectionConfig const& a, DetectionConfig const& b) {
    constexpr double margin = 10;
    double const left = std::min(a.left, b.left) - margin, top = std::min(a.top, b.top) - margin;
    double const right = std::max(a.left + a.width, b.left + b.width) + margin;
    double const bottom = std::max(a.top + a.height, b.top + b.height) + margin;
    int const needed = static_cast<int>(std::ceil(std::max(right - left, bottom - top)));
    int const side = needed <= least_side ? least_side : std::max(2 * least_side, needed);
    return {static_cast<int>((top + bottom - side) / 2), static_cast<int>((left + right - side) / 2), side};
}

DetectionConfig box_of(estimation::Scene const& scene, Pose const& pose) {
    return estimation::box_around(scene.observed.posed.mesh.vertices, pose, scene.observed.posed.camera);
}

/// Pixels that a pose covers and that have a neighbour which it does not cover.
Image<std::uint8_t> outline(estimation::Scene const& scene, Pose const& pose) {
    Camera const& camera = scene.observed.posed.camera;
    workload::DepthImage depth(camera.height, camera.width);
    workload::draw_mesh(scene.observed.posed.mesh, pose, camera, depth);
    Image<std::uint8_t> outline(camera.height, camera.width);
    for (int row = 1; row + 1 < camera.height; ++row)
        for (int col = 1; col + 1 < camera.width; ++col)
            outline.at(row, col) =
                depth.at(row, col) > 0 && (depth.at(row - 1, col) <= 0 || depth.at(row + 1, col) <= 0 ||
                                           depth.at(row, col - 1) <= 0 || depth.at(row, col + 1) <= 0);
    return outline;
}

/// Grey for depth codes of a part: what all but a few pixels have, from light to dark in few steps, which makes small
/// files.
class Greys {
  public:
    Greys(Image<std::uint16_t> const& depth, Part const& part) {
        std::vector<std::uint16_t> codes;
        for (int row = std::max(0, part.top); row < std::min(depth.height(), part.top + part.side); ++row)
            for (int col = std::max(0, part.left); col < std::min(depth.width(), part.left + part.side); ++col)
                if (depth.at(row, col) != 0)
                    codes.push_back(depth.at(row, col));
        std::sort(codes.begin(), codes.end());
        if (codes.empty())
            return;
        near_ = codes[codes.size() / 50];
        far_ = std::max<double>(near_ + 1, codes[codes.size() - 1 - codes.size() / 50]);
    }

    Colour of(std::uint16_t code) const {
        constexpr double steps = 12, lightest = 240, darkest = 110;
        if (code == 0)
            return palette_of_nothing;
        double const share = std::clamp((code - near_) / (far_ - near_), 0.0, 1.0);
        auto const grey =
            static_cast<std::uint8_t>(lightest - (lightest - darkest) * std::round(share * steps) / steps);
        return {grey, grey, grey};
    }

  private:
    static constexpr Colour palette_of_nothing = pictures::palette::paper;
    double near_ = 0;
    double far_ = 1;
};

Image<Colour> picture_of(Failure const& failure) {
    namespace palette = pictures::palette;
    estimation::Scene const scene = scene_of(*failure.wanted);
    Pose const estimated = scene.centred(failure.result->pose);
    Stimulus const& observed = scene.observed;
    Pose const& true_pose = nearest_truth(scene, estimated)->pose;
    Part const part = part_around(box_of(scene, true_pose), box_of(scene, estimated));
    Image<std::uint8_t> const truth = outline(scene, true_pose), estimate = outline(scene, estimated);
    Greys const greys(observed.observed_depth, part);
    Image<Colour> picture(part.side, part.side, palette::paper);
    for (int row = 0; row < part.side; ++row)
        for (int col = 0; col < part.side; ++col) {
            int const r = row + part.top, c = col + part.left;
            if (!truth.contains(r, c))
                continue;
            picture.at(row, col) = estimate.at(r, c) != 0                  ? palette::edge_map
                                   : truth.at(r, c) != 0                   ? true_outline
                                   : observed.observed_edges.at(r, c) != 0 ? palette::observed_edges
                                                                           : greys.of(observed.observed_depth.at(r, c));
        }
    return picture;
}

std::string label_of(Failure const& failure) {
    bool const is_turned = failure.reason == FailureReason::symmetry || failure.reason == FailureReason::turned;
    return fmt::format("{} {}/{}: {}{:.0f} mm, {} {:.2f}/{:.2f}", failure.wanted->method->name,
                       failure.wanted->target.image.im_id, failure.wanted->target.obj_id, is_turned ? "ADD " : "",
                       is_turned ? failure.add_mm : failure.adds_mm, enumerator_name(failure.reason),
                       failure.result->weight, failure.result->truth_weight);
}

constexpr double wrong_m = 0.02;
constexpr double least_overlap = 0.1;
constexpr double least_in_window = 0.9;
constexpr double least_visible = 0.1;

bool was_seen(estimation::Scene const& scene, Pose const& pose) {
    DetectionConfig const truth = box_of(scene, pose);
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

/// Of the object's box, at a pose.
double share_in_window(estimation::Scene const& scene, Pose const& pose) {
    DetectionConfig const box = box_of(scene, pose);
    Camera const& camera = scene.observed.posed.camera;
    Eigen::Vector3d const& middle = pose.translation;
    double const area = box.width * box.height;
    double const inside =
        stretch_in_window(box.left, box.width, camera.fx * middle.x() / middle.z() + camera.cx, scene.observed.window) *
        stretch_in_window(box.top, box.height, camera.fy * middle.y() / middle.z() + camera.cy, scene.observed.window);
    return area > 0 ? inside / area : 0;
}

FailureReason reason_of(WantedEstimate const& wanted, experiments::EstimateResult const& result,
                        estimation::Scene const& scene, estimation::TruePose const& truth,
                        poses::EstimateErrors const& off) {
    bool const has_window = estimator_of(wanted.method->loaded.config).backend == EstimatorBackend::accelerator;
    if (off.mssd_m < wrong_m)
        return FailureReason::symmetry;
    if (off.add_s_m < wrong_m)
        return FailureReason::turned;
    if (!was_seen(scene, truth.pose))
        return FailureReason::box;
    if (has_window && share_in_window(scene, truth.pose) < least_in_window)
        return FailureReason::size;
    if (truth.visible_share.value_or(1) < least_visible)
        return FailureReason::hidden;
    return result.weight >= result.truth_weight ? FailureReason::score : FailureReason::search;
}

std::optional<Failure> looked_at(WantedEstimate const& wanted, experiments::EstimateResult const& result,
                                 std::optional<poses::EstimateErrors> const& off) {
    if (!off || off->add_m < wrong_m)
        return std::nullopt;
    estimation::Scene const scene = scene_of(wanted);
    estimation::TruePose const& truth = *nearest_truth(scene, scene.centred(result.pose));
    return Failure{&wanted,
                   &result,
                   1000 * off->add_m,
                   1000 * off->add_s_m,
                   1000 * off->mssd_m,
                   truth.visible_share,
                   reason_of(wanted, result, scene, truth, *off)};
}

}  // namespace

void JudgedErrors::add(SettingData const& setting, MethodData const& method, std::vector<WantedEstimate> const& wanted,
                       experiments::EstimateJournal const& journal, poses::Judgement const& judgement) {
    std::map<std::size_t, poses::EstimateErrors> by_line;
    for (poses::EstimateErrors const& estimate : judgement.estimates)
        by_line[estimate.line] = estimate;
    std::size_t line = 1;  // names the columns
    for_each_result(wanted, journal, setting, method, [&](WantedEstimate const& each, auto const&) {
        if (auto const found = by_line.find(++line); found != by_line.end())
            errors_.emplace(&each, found->second);
    });
}

std::optional<poses::EstimateErrors> JudgedErrors::of(WantedEstimate const& wanted) const {
    auto const found = errors_.find(&wanted);
    return found == errors_.end() ? std::nullopt : std::optional(found->second);
}

std::vector<Failure> worst_of(std::vector<Failure> const& failures, SettingData const& setting, std::size_t most) {
    std::map<FailureReason, std::vector<Failure>> by_reason;
    for (Failure const& each : failures)
        if (each.wanted->setting == &setting)
            by_reason[each.reason].push_back(each);
    std::size_t longest = 0;
    for (auto& [reason, list] : by_reason) {
        std::stable_sort(list.begin(), list.end(),
                         [](Failure const& a, Failure const& b) { return a.adds_mm > b.adds_mm; });
        longest = std::max(longest, list.size());
    }
    std::vector<Failure> worst;
    for (std::size_t place = 0; place < longest; ++place)
        for (auto const& [reason, list] : by_reason)
            if (place < list.size() && worst.size() < most)
                worst.push_back(list[place]);
    return worst;
}

Image<Colour> failure_sheet(std::vector<Failure> const& failures) {
    pictures::ConvergenceSheet sheet(failures.size());
    for (Failure const& each : failures)
        sheet.add(label_of(each), picture_of(each));
    return sheet.picture();
}

std::vector<Failure> failures_among(std::vector<WantedEstimate> const& wanted,
                                    experiments::EstimateJournal const& journal, JudgedErrors const& errors) {
    std::vector<Failure> failures;
    ProgressLine progress("estimates looked at");
    CountedProgress done(wanted.size(), progress.teller());
    for (WantedEstimate const& each : wanted) {
        if (experiments::EstimateResult const* const result = journal.find(each.id))
            if (std::optional<Failure> const failure = looked_at(each, *result, errors.of(each)))
                failures.push_back(*failure);
        done.one_more();
    }
    return failures;
}

std::string failures_csv(std::vector<Failure> const& failures) {
    std::string text =
        "setting,method,scene_id,im_id,obj_id,visible_share,weight,truth_weight,add_mm,adds_mm,mssd_mm,reason\n";
    for (Failure const& each : failures) {
        WantedEstimate const& wanted = *each.wanted;
        fmt::format_to(
            std::back_inserter(text), "{},{},{},{},{},{},{:.6f},{:.6f},{:.4f},{:.4f},{:.4f},{}\n", wanted.setting->name,
            wanted.method->name, wanted.target.image.scene_id, wanted.target.image.im_id, wanted.target.obj_id,
            each.visible_share ? fmt::format("{:.4f}", *each.visible_share) : "", each.result->weight,
            each.result->truth_weight, each.add_mm, each.adds_mm, each.mssd_mm, enumerator_name(each.reason));
    }
    return text;
}

std::string failures_table(std::vector<Failure> const& failures, std::vector<SettingData> const& settings,
                           std::vector<MethodData> const& methods) {
    std::string text = "| setting | method |", rule = "\n| --- | --- |";
    for (std::string_view const reason : enumerator_names<FailureReason>) {
        text += fmt::format(" {} |", reason);
        rule += " --- |";
    }
    text += rule + "\n";
    for (SettingData const& setting : settings)
        for (MethodData const& method : methods) {
            std::array<std::size_t, enum_size<FailureReason>()> counts{};
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
