#pragma once
#include "faster/config/estimator_config.hpp"
#include "faster/data/sample_counters.hpp"
#include "poses/grip/inlier_ratio.hpp"

namespace faster::estimation {

/// The factors of thesis eq. 2.4 for one sample.
struct WeightTerms {
    double box = 0;     ///< w_box, confidence of its box
    double in_box = 0;  ///< I_b
    double raw = 0;     ///< I_r
    double edge = 0;    ///< I_e
    double planar = 0;  ///< I_p

    double weight(WeightCoefficients const& a) const {
        return a.box * box + a.in_box * in_box + a.raw * raw + a.edge * edge + a.planar * planar;
    }
};

/// Of the accelerator's counters: I_r = inlier / valid_raster, at most 1 (pixels of the contour are inliers too, but no
/// draws), I_e = edge_inlier / valid_edge. Counters do not say where the inliers lie: I_b = I_r times `box_overlap`,
/// the overlap_share() of the sample's box and its detection. All 0 if fewer than `least_drawn` fragments were drawn.
WeightTerms terms_of(SampleCounters const& counters, double confidence, double box_overlap, std::uint64_t least_drawn);

/// Of GRIP's clouds, by eq. 2.3. All 0 with fewer than `least_drawn` points.
WeightTerms terms_of(grip::PoseScore const& score, double confidence, std::uint64_t least_drawn);

}  // namespace faster::estimation
