#include "kernel/compare/comparison_json.hpp"

#include "kernel/base/files/json_file.hpp"
#include "kernel/base/json.hpp"
#include "kernel/config/design.hpp"

namespace faster::runs {

namespace {

template <class Value> Json or_null(std::optional<Value> const& value) { return value ? Json(*value) : Json(); }

Json head(RunHead const& run) {
    return {{"folder", run.folder}, {"samples", run.samples}, {"raster_cores", run.raster_cores}};
}

Json figure(Change const& change) {
    return {{"a", or_null(change.a)},
            {"b", or_null(change.b)},
            {"difference", change.difference()},
            {"percent", or_null(percent_of(static_cast<double>(change.a.value_or(0)),
                                           static_cast<double>(change.b.value_or(0))))}};
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

}  // namespace faster::runs
