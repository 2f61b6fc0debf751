#include "reference/quality/survey_table.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "faster/enum_names.hpp"

namespace faster::quality {

namespace {

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
        total->include(row);
    }
    return totals;
}

}  // namespace

std::string name_of(EdgeMapAlgorithm algorithm) { return choice_name(algorithm); }

std::string survey_csv(std::vector<PoseSurvey> const& rows) {
    std::string text = "algorithm,object,poses,precision,recall,thickness,closed,thin,closed_and_thin\n";
    for (PoseSurvey const& row : rows)
        text += fmt::format("{},{},{},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f}\n", name_of(row.algorithm), row.object,
                            row.poses, row.mean(row.precision), row.mean(row.recall), row.mean(row.thickness),
                            row.share(row.closed), row.share(row.thin), row.share(row.closed_and_thin));
    return text;
}

std::string survey_markdown(std::vector<PoseSurvey> const& rows) {
    std::string text =
        "| algorithm | poses | precision | recall | thickness [px] | closed | thin | closed and thin |\n"
        "| --- | --- | --- | --- | --- | --- | --- | --- |\n";
    for (PoseSurvey const& row : totals_of(rows))
        text += fmt::format("| {} | {} | {:.1f} % | {:.1f} % | {:.2f} | {:.1f} % | {:.1f} % | {:.1f} % |\n",
                            name_of(row.algorithm), row.poses, 100 * row.mean(row.precision),
                            100 * row.mean(row.recall), row.mean(row.thickness), 100 * row.share(row.closed),
                            100 * row.share(row.thin), 100 * row.share(row.closed_and_thin));
    return text;
}

}  // namespace faster::quality
