#include "tb/grip_comparison.hpp"

#include <fmt/format.h>
#include <iterator>
#include <nlohmann/json.hpp>

#include "faster/enum_names.hpp"
#include "kernel/base/files/json_file.hpp"
#include "reference/grip/rank_correlation.hpp"

namespace faster {

namespace {

using Values = std::vector<double>;

double ratio(std::uint64_t part, std::uint64_t whole) {
    return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
}

template <class Rows, class Figure> Values figures(Rows const& rows, Figure figure) {
    Values values;
    for (auto const& row : rows)
        values.push_back(static_cast<double>(figure(row)));
    return values;
}

Values grip_weights(GripComparison const& comparison) {
    return figures(comparison.grip, [](grip::PoseScore const& score) { return score.weight(); });
}
Values flow_weights(GripComparison const& comparison) { return figures(comparison.counters, weight); }

/// A side's best sample.
struct Best {
    std::size_t sample;
    double add_mm;
};
Best best(GripComparison const& comparison, Values const& weights) {
    std::size_t const sample = grip::best_of(weights);
    return {sample, 1000 * comparison.add_m[sample]};
}

nlohmann::json best_json(GripComparison const& comparison, Values const& weights) {
    Best const found = best(comparison, weights);
    return {{"sample", found.sample}, {"add_mm", found.add_mm}};
}

}  // namespace

double raw_ratio(SampleCounters const& counters) { return ratio(counters.inlier, counters.valid_raster); }
double edge_ratio(SampleCounters const& counters) { return ratio(counters.edge_inlier, counters.valid_edge); }
double weight(SampleCounters const& counters) { return (raw_ratio(counters) + edge_ratio(counters)) / 2; }

std::vector<Agreement> agreements(GripComparison const& comparison) {
    auto const agreement = [&](char const* score, auto of_grip, auto of_flow) {
        return Agreement{
            score, grip::rank_correlation(figures(comparison.grip, of_grip), figures(comparison.counters, of_flow))};
    };
    using Score = grip::PoseScore;
    using Sums = SampleCounters;
    return {agreement(
                "weight", [](Score const& s) { return s.weight(); }, weight),
            agreement(
                "raw_ratio", [](Score const& s) { return s.raw.ratio(); }, raw_ratio),
            agreement(
                "edge_ratio", [](Score const& s) { return s.edge.ratio(); }, edge_ratio),
            agreement(
                "inliers", [](Score const& s) { return s.raw.inliers; }, [](Sums const& c) { return c.inlier; }),
            agreement(
                "edge_inliers", [](Score const& s) { return s.edge.inliers; },
                [](Sums const& c) { return c.edge_inlier; })};
}

/// What people call it: the preset, or the flow that was chosen on its own.
static std::string design_of(GripComparison const& comparison) {
    return comparison.flow == Flow::faster ? comparison.architecture : choice_name(comparison.flow);
}

std::string grip_text(GripComparison const& comparison) {
    std::string const design = design_of(comparison);
    std::size_t const samples = comparison.grip.size();
    std::string text =
        fmt::format("{} samples by GRIP, untimed, on {} host {}: {:.2f} s, {:.2f} ms per sample\n", samples,
                    comparison.jobs, comparison.jobs == 1 ? "core" : "cores", comparison.grip_seconds,
                    1000 * comparison.grip_seconds / static_cast<double>(samples));
    text += fmt::format("\n  {:<12} {:>12} {:>14}\n", "ranked by", "best sample", "its ADD [mm]");
    for (auto const& [name, weights] :
         {std::pair{std::string("grip"), grip_weights(comparison)}, {design, flow_weights(comparison)}}) {
        Best const found = best(comparison, weights);
        text += fmt::format("  {:<12} {:>12} {:>14.2f}\n", name, found.sample, found.add_mm);
    }
    text += fmt::format("\n  {:<12} rank correlation of grip and {} (Spearman)\n", "score", design);
    for (Agreement const& row : agreements(comparison))
        text += row.rank_correlation ? fmt::format("  {:<12} {:.3f}\n", row.score, *row.rank_correlation)
                                     : fmt::format("  {:<12} -\n", row.score);
    return text;
}

std::string grip_csv(GripComparison const& comparison) {
    std::string text =
        "sample,grip_points,grip_inliers,grip_edges,grip_edge_inliers,grip_planars,grip_planar_inliers,grip_weight,"
        "grip_rank,valid_raster,inlier,valid_edge,edge_inlier,flow_weight,flow_rank,add_mm\n";
    Values const grip_ranks = grip::ranks(grip_weights(comparison));
    Values const flow_ranks = grip::ranks(flow_weights(comparison));
    for (std::size_t i = 0; i < comparison.grip.size(); ++i) {
        grip::PoseScore const& g = comparison.grip[i];
        SampleCounters const& c = comparison.counters[i];
        fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{:.6f},{},{},{},{},{},{:.6f},{},{:.3f}\n", i,
                       g.raw.points, g.raw.inliers, g.edge.points, g.edge.inliers, g.planar.points, g.planar.inliers,
                       g.weight(), grip_ranks[i], c.valid_raster, c.inlier, c.valid_edge, c.edge_inlier, weight(c),
                       flow_ranks[i], 1000 * comparison.add_m[i]);
    }
    return text;
}

std::string grip_json(GripComparison const& comparison) {
    nlohmann::json correlations = nlohmann::json::object();
    for (Agreement const& row : agreements(comparison))
        correlations[row.score] =
            row.rank_correlation ? nlohmann::json(*row.rank_correlation) : nlohmann::json(nullptr);
    nlohmann::json summary;
    summary["format"] = "faster-grip";
    summary["version"] = 1;
    summary["samples"] = comparison.grip.size();
    summary["architecture"] = comparison.architecture;
    summary["flow"] = choice_name(comparison.flow);
    summary["best"] = {{"grip", best_json(comparison, grip_weights(comparison))},
                       {"flow", best_json(comparison, flow_weights(comparison))}};
    summary["rank_correlation"] = std::move(correlations);
    summary["host"] = {{"jobs", comparison.jobs},
                       {"grip_seconds", comparison.grip_seconds},
                       {"reference_seconds", comparison.reference_seconds}};
    return io::text_of(summary, 2) + "\n";
}

}  // namespace faster
