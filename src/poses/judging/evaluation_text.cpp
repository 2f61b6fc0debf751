#include "poses/judging/evaluation_text.hpp"

#include <cmath>
#include <fmt/format.h>

#include "dataflow/base/csv_cell.hpp"
#include "faster/dataflow_names.hpp"

namespace faster::poses {
namespace {

std::string range(Interval const& interval) {
    if (std::isnan(interval.value))
        return " - |";
    return fmt::format(" {:.1f} ({:.1f} .. {:.1f}) |", interval.value, interval.low, interval.high);
}

std::string signed_range(Interval const& interval) {
    if (std::isnan(interval.value))
        return " - |";
    auto const shown = [](double value) { return std::abs(value) < 0.05 ? 0.0 : value; };  // no -0.0
    return fmt::format(" {:+.1f} ({:+.1f} .. {:+.1f}) |", shown(interval.value), shown(interval.low),
                       shown(interval.high));
}

/// What `cell` makes of each score that has a place on the terminal.
template <class Cell> std::string brief(Cell const& cell) {
    std::string cells;
    for (std::size_t score = 0; score < score_count; ++score)
        cells += score_facts[score].is_brief ? cell(score) : "";
    return cells;
}

std::string header(std::vector<std::string> const& columns_before) {
    std::string names = "|", rule = "|";
    for (std::string const& column : columns_before) {
        names += " " + column + " |";
        rule += " --- |";
    }
    names += brief([](std::size_t score) { return fmt::format(" {} |", score_facts[score].title); });
    return names + "\n" + rule + brief([](std::size_t) { return " --- |"; }) + "\n";
}

std::string score_line(ScoreRow const& row) {
    return fmt::format("| {} | {} | {} | {} |{}\n", row.object, row.method, row.instances, row.estimated,
                       brief([&](std::size_t score) { return range(row.scores[score]); }));
}

std::string difference_line(ScoreRow const& row) {
    if (row.of == ScoreRow::Of::object)
        return "";
    return fmt::format("| {} | {} |{}\n", row.object, row.method,
                       brief([&](std::size_t score) { return signed_range(row.more_than_first[score]); }));
}

/// Lines of the methods' rows from method `first` on, an object's below each other.
template <class Line> std::string by_object(Evaluation const& evaluation, std::size_t first, Line const& line) {
    std::size_t const methods = evaluation.methods.size(), per_method = evaluation.rows.size() / methods;
    std::string lines;
    for (std::size_t object = 0; object < per_method; ++object) {
        for (std::size_t method = first; method < methods; ++method)
            lines += line(evaluation.rows[method * per_method + object]);
    }
    return lines;
}

std::string filter_words(Evaluation const& evaluation) {
    if (evaluation.visible_from <= 0)
        return "";
    std::string const unknown = evaluation.of_unknown_visibility > 0
                                    ? fmt::format(" ({} of unknown visibility)", evaluation.of_unknown_visibility)
                                    : "";
    return fmt::format(", each at least {:g} % visible{}", 100 * evaluation.visible_from, unknown);
}

std::string notes(Evaluation const& evaluation) {
    std::string text;
    for (JudgedMethod const& method : evaluation.methods) {
        if (method.mean_time_s >= 0)
            text += fmt::format("{}: {:.3f} s per image\n", method.name, method.mean_time_s);
        if (method.judgement.left_out > 0)
            text += fmt::format("{}: {} estimates are left out: no targets, or more than there are instances\n",
                                method.name, method.judgement.left_out);
    }
    return text.empty() ? "" : "\n" + text;
}

std::string known(double metres) { return std::isfinite(metres) ? fmt::format("{:.6f}", metres) : ""; }

std::string steps(AccuracyCurve const& curve, char const* error, std::vector<double> const& errors_m) {
    std::string text;
    for (std::size_t i = 0; i < errors_m.size(); ++i)
        text += fmt::format("{},{},{},{:.6f},{:.4f}\n", csv_cell(curve.method), csv_cell(curve.object), error,
                            errors_m[i], 100 * static_cast<double>(i + 1) / static_cast<double>(curve.instances));
    return text;
}

}  // namespace

std::string evaluation_markdown(Evaluation const& evaluation) {
    std::string text =
        fmt::format("{}: {} instances in {} images{}\nPer cent, and 95 % of {} bootstraps over the images, seed {}\n\n",
                    evaluation.dataset, evaluation.rows.back().instances, evaluation.images, filter_words(evaluation),
                    evaluation.replicates, evaluation.seed);
    text += header({"object", "method", "instances", "estimated"}) + by_object(evaluation, 0, score_line);
    if (evaluation.methods.size() > 1) {
        text += fmt::format("\nPoints more than {}, on the same draws\n\n", evaluation.methods.front().name);
        text += header({"object", "method"}) + by_object(evaluation, 1, difference_line);
    }
    return text + notes(evaluation);
}

std::string scores_csv(Evaluation const& evaluation) {
    std::string text = "method,object,obj_id,images,instances,estimated";
    for (ScoreFacts const& score : score_facts)
        text += fmt::format(",{0},{0}_low,{0}_high,{0}_more,{0}_more_low,{0}_more_high", score.name);
    text += "\n";
    for (ScoreRow const& row : evaluation.rows) {
        text += fmt::format("{},{},{},{},{},{}", csv_cell(row.method), csv_cell(row.object), row.obj_id, row.images,
                            row.instances, row.estimated);
        for (std::size_t score = 0; score < score_count; ++score) {
            for (Interval const& interval : {row.scores[score], row.more_than_first[score]})
                text += std::isnan(interval.value)
                            ? ",,,"
                            : fmt::format(",{:.4f},{:.4f},{:.4f}", interval.value, interval.low, interval.high);
        }
        text += "\n";
    }
    return text;
}

std::string errors_csv(Evaluation const& evaluation) {
    std::string text =
        "method,scene_id,im_id,obj_id,visible_share,add_m,add_s_m,mssd_m,mssd_hits,mspd_px,mspd_hits,vsd_recall\n";
    for (JudgedMethod const& method : evaluation.methods) {
        for (InstanceErrors const& instance : method.judgement.instances)
            text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{}\n", csv_cell(method.name), instance.image.scene_id,
                                instance.image.im_id, instance.obj_id,
                                instance.visible_share ? fmt::format("{:.4f}", *instance.visible_share) : "",
                                known(instance.add_m), known(instance.add_s_m), known(instance.mssd_m),
                                instance.mssd_hits, known(instance.mspd_px), instance.mspd_hits,
                                instance.vsd_recall ? fmt::format("{:.2f}", *instance.vsd_recall) : "");
    }
    return text;
}

std::string curves_csv(Evaluation const& evaluation) {
    std::string text = "method,object,error,threshold_m,accuracy\n";
    for (AccuracyCurve const& curve : evaluation.curves)
        text += steps(curve, "add_s", curve.add_s_m) + steps(curve, "add", curve.add_m);
    return text;
}

}  // namespace faster::poses
