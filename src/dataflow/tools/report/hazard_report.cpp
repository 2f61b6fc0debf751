#include "dataflow/tools/report/hazard_report.hpp"

#include <fmt/format.h>

#include "dataflow/base/grouped_digits.hpp"
#include "dataflow/run/config/choice_names.hpp"
#include "dataflow/run/figures/table_rows.hpp"

namespace dataflow::report {

namespace {

std::string counts_text(DependenceRow const& row) {
    std::string text;
    for (std::size_t distance = 1; distance < row.counts.size(); ++distance)
        text += fmt::format("{}{}: {}", distance > 1 ? ", " : "", distance, row.counts[distance]);
    return text.empty() ? "-" : text;
}

std::string stages_text(MachineDependence const& dependence) {
    return dependence.reads > 0 ? fmt::format("{} to {}", dependence.read_stage, dependence.write_stage)
                                : fmt::format("writes in {}", dependence.write_stage);
}

bool has_logic(DependenceRow const& row) { return row.dependence.handling != HazardHandling::report; }

std::string sentence(DependenceRow const& row) {
    if (row.hazards() == 0)
        return "";
    if (has_logic(row)) {
        std::string const done = row.dependence.interlocks()
                                     ? fmt::format("hazards, for which iterations wait {} cycles", row.interlock_cycles)
                                     : "forwarded";
        return fmt::format("  {} on {}: {} {}, by {} comparators and {} bits of registers a core.\n", row.name(),
                           row.bram, row.hazards(), done, row.comparators(), row.register_bits());
    }
    return fmt::format("  {} on {}: {} hazards. In hardware these iterations work on a stale word.\n", row.name(),
                       row.bram, row.hazards());
}

Json row_json(DependenceRow const& row) {
    Json counts = Json::array();
    for (std::size_t distance = 1; distance < row.counts.size(); ++distance)
        counts.push_back(row.counts[distance]);
    Json json{{"core", row.core},
              {"module", row.module},
              {"loop", row.loop},
              {"bram", row.bram},
              {"ii", row.ii},
              {"reads", row.dependence.reads > 0},
              {"read_stage", row.dependence.read_stage},
              {"write_stage", row.dependence.write_stage},
              {"span", row.dependence.span()},
              {"smallest_distance", row.smallest == 0 ? Json() : Json(row.smallest)},
              {"distances", std::move(counts)},
              {"hazards", row.hazards()},
              {"handling", choice_name(row.dependence.handling)}};
    json["interlock_cycles"] = row.interlock_cycles;
    json["comparators"] = has_logic(row) ? row.comparators() : 0;
    json["register_bits"] = has_logic(row) ? row.register_bits() : 0;
    return json;
}

}  // namespace

std::string hazards_text(RunStatistics const& run) {
    std::vector<DependenceRow> const rows = dependence_sums(run);
    if (rows.empty())
        return "";
    std::string text =
        "\nHazards: iterations that access a word which one shortly before has written; how many by distance "
        "[iterations]\n";
    text += fmt::format("  {:<25} {:<19} {:>3} {:<12} {:>5} {:>9} {:>12}  {}\n", "loop", "memory", "II", "stages",
                        "span", "smallest", "hazards", "below the span");
    for (DependenceRow const& row : rows)
        text += fmt::format("  {:<25} {:<19} {:>3} {:<12} {:>5} {:>9} {:>12}  {}\n", row.name(), row.bram, row.ii,
                            stages_text(row.dependence), row.dependence.span(),
                            row.smallest == 0 ? "-" : std::to_string(row.smallest), grouped(row.hazards()),
                            counts_text(row));
    for (DependenceRow const& row : rows)
        text += sentence(row);
    return text;
}

Json hazards_json(RunStatistics const& run) {
    Json rows = Json::array();
    for (DependenceRow const& row : dependence_rows(run))
        rows.push_back(row_json(row));
    return rows;
}

Json hazard_sums_json(RunStatistics const& run) {
    Json rows = Json::array();
    for (DependenceRow const& row : dependence_sums(run)) {
        rows.push_back(row_json(row));
        rows.back().erase("core");
    }
    return rows;
}

}  // namespace dataflow::report
