#include "tb/failure_pictures.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>

#include "tb/estimate_scene.hpp"
#include "workload/pictures/convergence_sheet.hpp"
#include "workload/pictures/palette.hpp"
#include "workload/scene_renderer.hpp"

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
    auto const box_of = [&](Pose const& pose) {
        return estimation::box_around(observed.posed.mesh.vertices, pose, observed.posed.camera);
    };
    Part const part = part_around(box_of(*scene.truth), box_of(estimated));
    Image<std::uint8_t> const truth = outline(scene, *scene.truth), estimate = outline(scene, estimated);
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
    bool const is_turned = failure.reason == FailureReason::symmetry;
    return fmt::format("{} {}/{}: {}{:.0f} mm, {} {:.2f}/{:.2f}", failure.wanted->method->name,
                       failure.wanted->target.image.im_id, failure.wanted->target.obj_id, is_turned ? "ADD " : "",
                       is_turned ? failure.add_mm : failure.adds_mm, failure.reason_name(), failure.result->weight,
                       failure.result->truth_weight);
}

}  // namespace

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

}  // namespace faster
