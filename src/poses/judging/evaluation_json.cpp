#include "poses/judging/evaluation_json.hpp"

#include <cmath>

#include "dataflow/base/files/json_file.hpp"
#include "dataflow/tools/report/html/fill_page.hpp"
#include "dataflow/tools/report/provenance.hpp"
#include "faster/dataflow_names.hpp"
#include "poses/judging/page.hpp"

namespace faster::poses {
namespace {

/// As many digits as a score or a metre has a use for: files stay short, and free of the last bits of a machine.
double rounded(double value, double digits) { return std::round(value * digits) / digits; }

Json json_of(Interval const& interval) {
    constexpr double digits = 1e4;
    if (std::isnan(interval.value))
        return nullptr;
    return {rounded(interval.value, digits), rounded(interval.low, digits), rounded(interval.high, digits)};
}

Json json_of(std::array<Interval, score_count> const& scores) {
    Json json = Json::object();
    for (std::size_t score = 0; score < score_count; ++score)
        json[score_facts[score].name] = json_of(scores[score]);
    return json;
}

Json json_of(ScoreRow const& row) {
    return {{"method", row.method},          {"object", row.object},
            {"obj_id", row.obj_id},          {"images", row.images},
            {"instances", row.instances},    {"estimated", row.estimated},
            {"scores", json_of(row.scores)}, {"more_than_first", json_of(row.more_than_first)}};
}

Json metres(std::vector<double> const& errors_m) {
    Json json = Json::array();
    for (double const error_m : errors_m)
        json.push_back(rounded(error_m, 1e6));
    return json;
}

Json json_of(AccuracyCurve const& curve) {
    return {{"method", curve.method},       {"object", curve.object},           {"obj_id", curve.obj_id},
            {"instances", curve.instances}, {"add_s_m", metres(curve.add_s_m)}, {"add_m", metres(curve.add_m)}};
}

Json json_of(JudgedMethod const& method) {
    Json json{{"name", method.name}, {"left_out", method.judgement.left_out}};
    json["mean_time_s"] = method.mean_time_s < 0 ? Json(nullptr) : Json(rounded(method.mean_time_s, 1e6));
    return json;
}

template <class Item> Json array_of(std::vector<Item> const& items) {
    Json json = Json::array();
    for (Item const& item : items)
        json.push_back(json_of(item));
    return json;
}

Json titles() {
    Json json = Json::object();
    for (ScoreFacts const& score : score_facts)
        json[score.name] = score.title;
    return json;
}

}  // namespace

Json evaluation_json(Evaluation const& evaluation) {
    return {{"format", "faster-evaluation"},
            {"version", 1},
            {"dataset", evaluation.dataset},
            {"images", evaluation.images},
            {"visible_from", evaluation.visible_from},
            {"of_unknown_visibility", evaluation.of_unknown_visibility},
            {"seed", evaluation.seed},
            {"replicates", evaluation.replicates},
            {"scores", titles()},
            {"methods", array_of(evaluation.methods)},
            {"rows", array_of(evaluation.rows)},
            {"curves", array_of(evaluation.curves)}};
}

std::string evaluation_html(Evaluation const& evaluation) {
    return report::filled_page(evaluation_page, "How far the poses are off", report::made_by_html(""),
                               io::text_of(evaluation_json(evaluation)));
}

}  // namespace faster::poses
