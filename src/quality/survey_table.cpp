#include "quality/survey_table.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "config/enum_names.hpp"

namespace faster::quality {

namespace {

double mean(double sum, PoseSurvey const& row) { return row.poses > 0 ? sum / static_cast<double>(row.poses) : 0; }
double share(std::size_t count, PoseSurvey const& row) { return mean(static_cast<double>(count), row); }

void add(PoseSurvey const& row, PoseSurvey& total) {
    total.poses += row.poses;
    total.precision += row.precision;
    total.recall += row.recall;
    total.thickness += row.thickness;
    total.closed += row.closed;
    total.thin += row.thin;
    total.closed_and_thin += row.closed_and_thin;
}

/// One per algorithm, in the order of their first rows.
std::vector<PoseSurvey> totals_of(std::vector<PoseSurvey> const& rows) {
    std::vector<PoseSurvey> totals;
    for (PoseSurvey const& row : rows) {
        auto total = std::find_if(totals.begin(), totals.end(),
                                  [&row](PoseSurvey const& other) { return other.algorithm == row.algorithm; });
        if (total == totals.end()) {
            totals.emplace_back();
            total = totals.end() - 1;
            total->algorithm = row.algorithm;
        }
        add(row, *total);
    }
    return totals;
}

}  // namespace

std::string name_of(EdgeMapAlgorithm algorithm) { return choice_name(algorithm); }

std::string survey_csv(std::vector<PoseSurvey> const& rows) {
    std::string text = "algorithm,object,poses,precision,recall,thickness,closed,thin,closed_and_thin\n";
    for (PoseSurvey const& row : rows)
        text += fmt::format("{},{},{},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f}\n", name_of(row.algorithm), row.object,
                            row.poses, mean(row.precision, row), mean(row.recall, row), mean(row.thickness, row),
                            share(row.closed, row), share(row.thin, row), share(row.closed_and_thin, row));
    return text;
}

std::string survey_markdown(std::vector<PoseSurvey> const& rows) {
    std::string text =
        "| algorithm | poses | precision | recall | thickness [px] | closed | thin | closed and thin |\n"
        "| --- | --- | --- | --- | --- | --- | --- | --- |\n";
    for (PoseSurvey const& row : totals_of(rows))
        text += fmt::format("| {} | {} | {:.1f} % | {:.1f} % | {:.2f} | {:.1f} % | {:.1f} % | {:.1f} % |\n",
                            name_of(row.algorithm), row.poses, 100 * mean(row.precision, row),
                            100 * mean(row.recall, row), mean(row.thickness, row), 100 * share(row.closed, row),
                            100 * share(row.thin, row), 100 * share(row.closed_and_thin, row));
    return text;
}

}  // namespace faster::quality
