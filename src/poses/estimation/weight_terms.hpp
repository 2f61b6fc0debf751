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

/// How what a sample covers in the image lies to the box it began in.
struct BoxFit {
    double overlap = 0;  ///< overlap_share() of the two
    double inside = 0;   ///< share_inside() the detection's of the sample's
};

/// What a sample's terms are made by, besides its score.
struct TermSettings {
    InBoxTerm in_box = InBoxTerm::overlap;
    std::uint64_t least_drawn = 0;  ///< a sample that drew less has no terms but that of its box
    double hidden = 0;              ///< share of the hidden pixels that does not count as drawn
};

/// Of the accelerator's counters: I_r = inlier / (valid_raster - settings.hidden hidden), at most 1 (pixels of the
/// contour are inliers too, but no draws), I_e = edge_inlier / valid_edge. Counters do not say where the inliers lie:
/// for I_b by points, they are taken as spread evenly over what the sample covers.
WeightTerms terms_of(SampleCounters const& counters, double confidence, BoxFit const& fit,
                     TermSettings const& settings);

/// Of GRIP's clouds, by eq. 2.3.
WeightTerms terms_of(grip::PoseScore const& score, double confidence, BoxFit const& fit, TermSettings const& settings);

}  // namespace faster::estimation
