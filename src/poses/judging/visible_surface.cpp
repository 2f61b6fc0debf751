#include "poses/judging/visible_surface.hpp"

#include <algorithm>
#include <cmath>

#include "poses/grip/rendered_object.hpp"

namespace faster::poses {
namespace {

/// Depths of a part of the image become distances.
void to_distances(DistanceImage& part, Camera const& camera) {
    for (int row = 0; row < part.distances.height(); ++row) {
        double const y = (row + part.top - camera.cy) / camera.fy;
        for (int col = 0; col < part.distances.width(); ++col) {
            double const x = (col + part.left - camera.cx) / camera.fx;
            part.distances.at(row, col) *= std::sqrt(x * x + y * y + 1);
        }
    }
}

/// How the two poses' visible pixels differ.
struct VisibleDifference {
    std::size_t together = 0;                                 ///< visible in one of them
    std::size_t only_one = 0;                                 ///< not in both
    std::array<std::size_t, vsd_tolerances> too_far_apart{};  ///< in both, by tolerance

    void count(bool in_estimate, bool in_truth, double apart) {
        together += in_estimate || in_truth ? 1U : 0U;
        only_one += in_estimate != in_truth ? 1U : 0U;
        for (std::size_t i = 0; in_estimate && in_truth && i < vsd_tolerances; ++i)
            too_far_apart[i] += apart >= 0.05 * static_cast<double>(i + 1) ? 1U : 0U;
    }
};

}  // namespace

DistanceImage seen_distances(bop::Observation const& observation) {
    DistanceImage seen{0, 0, observation.depth};
    to_distances(seen, observation.camera);
    return seen;
}

DistanceImage drawn_distances(Mesh const& mesh, Pose const& pose, Camera const& camera) {
    constexpr double nearest_m = 0.01;  // where bop_toolkit's renderer begins, too
    grip::RenderedObject object = grip::render(mesh, pose, camera, nearest_m);
    DistanceImage drawn{object.first_row, object.first_col, std::move(object.depth)};
    to_distances(drawn, camera);
    return drawn;
}

std::array<double, vsd_tolerances> vsd(DistanceImage const& seen, DistanceImage const& estimate,
                                       DistanceImage const& truth, double delta_m, double diameter_m) {
    auto const bottom = [](DistanceImage const& image) { return image.top + image.distances.height(); };
    auto const right = [](DistanceImage const& image) { return image.left + image.distances.width(); };
    VisibleDifference difference;
    for (int row = std::min(estimate.top, truth.top); row < std::max(bottom(estimate), bottom(truth)); ++row) {
        for (int col = std::min(estimate.left, truth.left); col < std::max(right(estimate), right(truth)); ++col) {
            double const there = seen.at(row, col), e = estimate.at(row, col), t = truth.at(row, col);
            bool const in_truth = t > 0 && (there == 0 || t - there <= delta_m);
            bool const in_estimate = e > 0 && (there == 0 || e - there <= delta_m || in_truth);
            difference.count(in_estimate, in_truth, std::abs(t - e) / diameter_m);
        }
    }
    std::array<double, vsd_tolerances> errors{};
    for (std::size_t i = 0; i < vsd_tolerances; ++i)
        errors[i] = difference.together == 0 ? 1
                                             : static_cast<double>(difference.too_far_apart[i] + difference.only_one) /
                                                   static_cast<double>(difference.together);
    return errors;
}

}  // namespace faster::poses
