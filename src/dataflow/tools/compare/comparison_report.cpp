#include "dataflow/tools/compare/comparison_report.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>

#include "dataflow/base/files/json_file.hpp"
#include "dataflow/base/grouped_digits.hpp"
#include "dataflow/base/json.hpp"
#include "dataflow/base/text_lines.hpp"
#include "dataflow/run/config/design.hpp"

namespace dataflow::runs {

namespace {

Json head(RunHead const& run) {
    return {{"folder", run.folder}, {"samples", run.samples}, {"raster_cores", run.raster_cores}};
}

Json figure(Change const& change) {
    return {{"a", or_null(change.a)},
            {"b", or_null(change.b)},
            {"difference", change.difference()},
            {"percent", or_null(change.percent())}};
}

Json milliseconds(double a, double b) {
    return {{"a", a}, {"b", b}, {"difference", b - a}, {"percent", or_null(percent_of(a, b))}};
}

Json setting(std::optional<std::string> const& value) { return value ? Json::parse(*value) : Json(); }

Json settings(std::vector<SettingChange> const& changes) {
    Json rows = Json::array();
    for (SettingChange const& change : changes)
        rows.push_back({{"key", change.key}, {"a", setting(change.a)}, {"b", setting(change.b)}});
    return rows;
}

Json counters(Counters const& counters) {
    Json object = Json::object();
    for (std::size_t i = 0; i < counters.size(); ++i)
        object[design().counters()[i].name] = counters[i];
    return object;
}

Json results(Comparison const& comparison) {
    Json rows = Json::array();
    for (SampleChange const& change : comparison.samples)
        rows.push_back({{"sample", change.sample}, {"a", counters(change.a)}, {"b", counters(change.b)}});
    return {{"equal", comparison.is_functionally_equal()},
            {"compared_samples", comparison.compared_samples},
            {"different_samples", rows}};
}

Json figures(std::vector<ChangeList> const& lists) {
    Json object = Json::object();
    for (ChangeList const& list : lists) {
        Json& rows = object[list.name] = Json::array();
        for (Change const& change : list.changes) {
            Json row = {{"item", change.item}, {"figure", change.figure}};
            row.update(figure(change));
            rows.push_back(row);
        }
    }
    return object;
}

void left_out(std::string& text, std::size_t rows, std::size_t top) {
    if (rows > top)
        put_line(text, "  ... and {} more (--top)", rows - top);
}

using Row = std::array<std::string, 5>;

/// Names to the left, figures to the right, each column as wide as its widest cell.
void table(std::string& text, std::vector<Row> const& rows) {
    auto const widths = widths_of(rows);
    for (Row const& row : rows) {
        text += fmt::format("  {:<{}}", row[0], widths[0]);
        for (std::size_t i = 1; i < row.size(); ++i)
            text += fmt::format("  {:>{}}", row[i], widths[i]);
        text += '\n';
    }
}

Row heading() { return {"", "A", "B", "difference", "percent"}; }

std::string percent_text(std::optional<double> percent) { return percent ? fmt::format("{:+.2f}", *percent) : "-"; }

Row row_of(std::string const& name, Change const& change) {
    return {name, grouped(change.a), grouped(change.b), grouped_change(change.difference()),
            percent_text(change.percent())};
}

void run_line(std::string& text, char const* name, RunHead const& run) {
    put_line(text, "{}  {} ({} samples, {} {})", name, run.folder, run.samples, run.raster_cores, cores_are());
}

void heads(std::string& text, Comparison const& comparison) {
    run_line(text, "A", comparison.a);
    run_line(text, "B", comparison.b);
    for (std::string const& note : comparison.notes)
        put_line(text, "note: {}", note);
}

void settings(std::string& text, std::vector<SettingChange> const& changes, std::size_t top) {
    for (std::size_t i = 0; i < std::min(top, changes.size()); ++i)
        put_line(text, "  {}: {} -> {}", changes[i].key, changes[i].a.value_or("-"), changes[i].b.value_or("-"));
    left_out(text, changes.size(), top);
}

void configuration(std::string& text, Comparison const& comparison, std::size_t top) {
    if (comparison.configuration.empty()) {
        put_line(text, "\nConfiguration: the same");
        return;
    }
    put_line(text, "\nConfiguration: {} of {} keys differ", comparison.configuration.size(), comparison.keys);
    settings(text, comparison.configuration, top);
}

void headline(std::string& text, RunHead const& a, RunHead const& b) {
    put_line(text, "\nTotal");
    table(text, {heading(),
                 row_of("cycles", {"", "", a.total_cycles, b.total_cycles}),
                 {"ms", fmt::format("{:.3f}", a.milliseconds), fmt::format("{:.3f}", b.milliseconds),
                  fmt::format("{:+.3f}", b.milliseconds - a.milliseconds),
                  percent_text(percent_of(a.milliseconds, b.milliseconds))}});
}

std::string counter_changes(SampleChange const& change) {
    std::string text;
    for (std::size_t i = 0; i < std::min(change.a.size(), change.b.size()); ++i)
        if (change.a[i] != change.b[i])
            text += fmt::format("{}{} {} -> {}", text.empty() ? "" : ", ", design().counters()[i].name, change.a[i],
                                change.b[i]);
    return text;
}

void results(std::string& text, Comparison const& comparison, std::size_t top) {
    std::size_t const different = comparison.samples.size();
    if (different == 0) {
        put_line(text, "\nResults: the same in all {} samples", comparison.compared_samples);
        return;
    }
    put_line(text, "\nResults: {} of {} samples differ", different, comparison.compared_samples);
    for (std::size_t i = 0; i < std::min(top, different); ++i)
        put_line(text, "  sample {}: {}", comparison.samples[i].sample, counter_changes(comparison.samples[i]));
    left_out(text, different, top);
}

void fifo_shapes(std::string& text, Comparison const& comparison, std::size_t top) {
    if (comparison.fifo_shapes.empty())
        return;
    put_line(text, "\nFIFOs: depth and kind");
    settings(text, comparison.fifo_shapes, top);
}

void figures(std::string& text, ChangeList const& list, std::size_t top) {
    if (list.changes.empty())
        return;
    put_line(text, "\n{}", list.title);
    std::vector<Row> rows{heading()};
    for (std::size_t i = 0; i < std::min(top, list.changes.size()); ++i)
        rows.push_back(row_of(list.changes[i].item + " " + list.changes[i].figure, list.changes[i]));
    table(text, rows);
    left_out(text, list.changes.size(), top);
}

bool has_figures(Comparison const& comparison) {
    return std::any_of(comparison.figures.begin(), comparison.figures.end(),
                       [](ChangeList const& list) { return !list.changes.empty(); });
}

}  // namespace

std::string comparison_json(Comparison const& comparison) {
    RunHead const& a = comparison.a;
    RunHead const& b = comparison.b;
    Json json;
    json["format"] = "faster-comparison";
    json["version"] = 1;
    json["identical"] = comparison.identical;
    json["a"] = head(a);
    json["b"] = head(b);
    json["notes"] = comparison.notes;
    json["configuration"] = settings(comparison.configuration);
    json["total_cycles"] = figure({"", "", a.total_cycles, b.total_cycles});
    json["milliseconds"] = milliseconds(a.milliseconds, b.milliseconds);
    json["results"] = results(comparison);
    json["fifo_shapes"] = settings(comparison.fifo_shapes);
    json["figures"] = figures(comparison.figures);
    // A folder's name is whatever bytes the file system allows.
    return io::text_of(json, 2) + "\n";
}

std::string comparison_text(Comparison const& comparison, std::size_t top) {
    std::string text;
    if (comparison.identical) {
        put_line(text, "identical: configuration, results and cycles of {} and {} ({} samples, {} cycles)",
                 comparison.a.folder, comparison.b.folder, comparison.a.samples, grouped(comparison.a.total_cycles));
        return text;
    }
    heads(text, comparison);
    headline(text, comparison.a, comparison.b);
    configuration(text, comparison, top);
    results(text, comparison, top);
    fifo_shapes(text, comparison, top);
    for (ChangeList const& list : comparison.figures)
        figures(text, list, top);
    if (!has_figures(comparison))
        put_line(text, "\nFigures: the same, summed over cores");
    return text;
}

}  // namespace dataflow::runs
