#include "poses/estimation/weight_terms.hpp"

#include <algorithm>

namespace faster::estimation {

namespace {

double in_box_by_counters(InBoxTerm term, double raw, BoxFit const& fit) {
    switch (term) {
        case InBoxTerm::overlap:
            return raw * fit.overlap;
        case InBoxTerm::all_points:
            return raw * fit.inside;
        case InBoxTerm::box_points:
            return fit.inside > 0 ? raw : 0;
        case InBoxTerm::none:
            break;
    }
    return 0;
}

double in_box_by_points(InBoxTerm term, grip::PoseScore const& score, BoxFit const& fit) {
    switch (term) {
        case InBoxTerm::overlap:
            return score.raw.ratio() * fit.overlap;
        case InBoxTerm::all_points:
            return grip::InlierCount{score.raw.points, score.in_box.inliers}.ratio();
        case InBoxTerm::box_points:
            return score.in_box.ratio();
        case InBoxTerm::none:
            break;
    }
    return 0;
}

}  // namespace

WeightTerms terms_of(SampleCounters const& counters, double confidence, BoxFit const& fit,
                     TermSettings const& settings) {
    WeightTerms terms;
    terms.box = confidence;
    if (counters.valid_raster < settings.least_drawn)
        return terms;
    double const looked_for =
        static_cast<double>(counters.valid_raster) - settings.hidden * static_cast<double>(counters.hidden);
    terms.raw = looked_for > 0 ? std::min(1.0, static_cast<double>(counters.inlier) / looked_for) : 0;
    terms.in_box = in_box_by_counters(settings.in_box, terms.raw, fit);
    terms.edge = grip::InlierCount{counters.valid_edge, counters.edge_inlier}.ratio();
    return terms;
}

WeightTerms terms_of(grip::PoseScore const& score, double confidence, BoxFit const& fit, TermSettings const& settings) {
    WeightTerms terms;
    terms.box = confidence;
    if (score.raw.points < settings.least_drawn)
        return terms;
    terms.in_box = in_box_by_points(settings.in_box, score, fit);
    terms.raw = score.raw.ratio();
    terms.edge = score.edge.ratio();
    terms.planar = score.planar.ratio();
    return terms;
}

}  // namespace faster::estimation
