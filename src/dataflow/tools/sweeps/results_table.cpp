#include "dataflow/tools/sweeps/results_table.hpp"

#include <fmt/format.h>

#include "dataflow/base/csv_cell.hpp"
#include "dataflow/base/enumerators.hpp"

namespace dataflow::sweeps {

namespace {

std::string cell(ResultFigure const& figure, PointResult const& result) {
    if (result.status == PointResult::Status::failed ||
        (result.status == PointResult::Status::deadlock && figure.of_a_run))
        return "";
    return std::visit([&](auto const member) { return fmt::format(fmt::runtime(figure.format), result.*member); },
                      figure.member);
}

}  // namespace

std::vector<std::string> const& result_columns() {
    static std::vector<std::string> const columns = [] {
        std::vector<std::string> names{"point", "status"};
        for (ResultFigure const& figure : result_figures)
            names.emplace_back(figure.name);
        names.emplace_back("message");
        return names;
    }();
    return columns;
}

std::vector<PointWithResult> points_with_results(Manifest const& manifest, Results const& results) {
    std::vector<PointWithResult> points;
    for (std::size_t i = 0; i < manifest.points.size(); ++i)
        if (auto const found = results.find(manifest.points[i].id); found != results.end())
            points.push_back({i, found->second});
    return points;
}

std::string results_csv(Manifest const& manifest, Results const& results) {
    std::string text = "point";
    for (std::string const& column : manifest.columns)
        text += "," + csv_cell(column);
    for (std::size_t i = 1; i < result_columns().size(); ++i)
        text += "," + result_columns()[i];
    text += "\n";
    for (auto const& [i, result] : points_with_results(manifest, results)) {
        text += std::to_string(i);
        for (std::string const& value : manifest.points[i].values)
            text += "," + csv_cell(value);
        text += fmt::format(",{}", enumerator_name(result.status));
        for (ResultFigure const& figure : result_figures)
            text += "," + cell(figure, result);
        text += "," + csv_cell(result.message) + "\n";
    }
    return text;
}

}  // namespace dataflow::sweeps
