#include "report/sensitivity_report.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>
#include <limits>

namespace faster::report {

namespace {

constexpr std::size_t most_lines = 20;

std::int64_t change_of(SensitivityStep const& step, RunStatistics const& run) {
    return static_cast<std::int64_t>(step.total_cycles) - static_cast<std::int64_t>(run.total_cycles);
}

bool finishes(SensitivityStep const& step) { return step.valid && !step.deadlocks; }

bool changes(SensitivityStep const& step, RunStatistics const& run) {
    return step.valid && (step.deadlocks || change_of(step, run) != 0);
}

std::int64_t best_of(Sensitivity const& row, RunStatistics const& run) {
    std::int64_t best = std::numeric_limits<std::int64_t>::max();
    for (SensitivityStep const* step : {&row.down, &row.up})
        if (finishes(*step))
            best = std::min(best, change_of(*step, run));
    return best;
}

std::string cell(SensitivityStep const& step, RunStatistics const& run) {
    if (!step.valid)
        return "not valid";
    if (step.deadlocks)
        return "deadlock";
    std::int64_t const change = change_of(step, run);
    return fmt::format("{:+} ({:+.2f} %)", change,
                       100.0 * static_cast<double>(change) / static_cast<double>(run.total_cycles));
}

char const* outcome(SensitivityStep const& step) {
    return !step.valid ? "invalid" : step.deadlocks ? "deadlock" : "finished";
}

void add_csv_row(std::string& text, Sensitivity const& row, int by, SensitivityStep const& step,
                 RunStatistics const& run) {
    fmt::format_to(std::back_inserter(text), "{},{},{},{},", row.key, row.value, row.value + by, outcome(step));
    if (finishes(step))
        fmt::format_to(std::back_inserter(text), "{},{}\n", step.total_cycles, change_of(step, run));
    else
        text += ",\n";
}

Json step_json(SensitivityStep const& step, RunStatistics const& run) {
    Json object = {{"outcome", outcome(step)}};
    if (finishes(step)) {
        object["total_cycles"] = step.total_cycles;
        object["change_cycles"] = change_of(step, run);
    }
    return object;
}

}  // namespace

std::string sensitivities_text(RunStatistics const& run) {
    if (run.sensitivities.empty())
        return "";
    std::vector<Sensitivity> rows;
    for (Sensitivity const& row : run.sensitivities)
        if (changes(row.down, run) || changes(row.up, run))
            rows.push_back(row);
    std::stable_sort(rows.begin(), rows.end(),
                     [&run](Sensitivity const& a, Sensitivity const& b) { return best_of(a, run) < best_of(b, run); });
    std::string text =
        fmt::format("\nSensitivities: change of the {} cycles by one step of one key, exact\n", run.total_cycles);
    text += fmt::format("  {:<47} {:>7} {:>22} {:>22}\n", "key", "value", "one less", "one more");
    for (std::size_t i = 0; i < rows.size() && i < most_lines; ++i)
        text += fmt::format("  {:<47} {:>7} {:>22} {:>22}\n", rows[i].key, rows[i].value, cell(rows[i].down, run),
                            cell(rows[i].up, run));
    if (rows.size() > most_lines)
        text += fmt::format("  ({} more in sensitivities.csv)\n", rows.size() - most_lines);
    std::size_t const idle = run.sensitivities.size() - rows.size();
    text += fmt::format("  {} {} nothing by one step.\n", idle, idle == 1 ? "key changes" : "keys change");
    return text;
}

std::string sensitivities_csv(RunStatistics const& run) {
    std::string text = "key,value,changed_value,outcome,total_cycles,change_cycles\n";
    for (Sensitivity const& row : run.sensitivities) {
        add_csv_row(text, row, -1, row.down, run);
        add_csv_row(text, row, 1, row.up, run);
    }
    return text;
}

Json sensitivities_json(RunStatistics const& run) {
    Json rows = Json::array();
    for (Sensitivity const& row : run.sensitivities)
        rows.push_back({{"key", row.key},
                        {"value", row.value},
                        {"down", step_json(row.down, run)},
                        {"up", step_json(row.up, run)}});
    return rows;
}

}  // namespace faster::report
