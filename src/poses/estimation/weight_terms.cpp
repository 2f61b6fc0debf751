#include "poses/estimation/weight_terms.hpp"

#include <algorithm>

namespace faster::estimation {

namespace {

double ratio(std::uint64_t part, std::uint64_t whole) {
    return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
}

}  // namespace

WeightTerms terms_of(SampleCounters const& counters, double confidence, double box_overlap, std::uint64_t least_drawn) {
    WeightTerms terms;
    terms.box = confidence;
    if (counters.valid_raster < least_drawn)
        return terms;
    terms.raw = std::min(1.0, ratio(counters.inlier, counters.valid_raster));
    terms.in_box = terms.raw * box_overlap;
    terms.edge = ratio(counters.edge_inlier, counters.valid_edge);
    return terms;
}

WeightTerms terms_of(grip::PoseScore const& score, double confidence, std::uint64_t least_drawn) {
    WeightTerms terms;
    terms.box = confidence;
    if (score.raw.points < least_drawn)
        return terms;
    terms.in_box = score.in_box.ratio();
    terms.raw = score.raw.ratio();
    terms.edge = score.edge.ratio();
    terms.planar = score.planar.ratio();
    return terms;
}

}  // namespace faster::estimation
