#include "dataflow/tools/report/sensitivity_report.hpp"

#include <algorithm>
#include <cstdlib>
#include <fmt/format.h>
#include <iterator>

#include "dataflow/base/enumerators.hpp"
#include "dataflow/base/files/json_file.hpp"
#include "dataflow/base/grouped_digits.hpp"

namespace dataflow::report {

namespace {

constexpr std::size_t most_steps = 20;

std::int64_t change_of(SensitivityStep const& step, RunStatistics const& run) {
    return static_cast<std::int64_t>(step.total_cycles) - static_cast<std::int64_t>(run.total_cycles);
}

bool changes(SensitivityStep const& step, RunStatistics const& run) {
    return step.valid && (!finishes(step) || change_of(step, run) != 0);
}

bool has_slack(RunStatistics const& run) {
    return !run.sensitivities.empty() && run.sensitivities.front().up.slack.has_value();
}

std::string slack_cell(Sensitivity const& row, std::int64_t direction, Slack const& slack) {
    if (slack.change == 0)
        return "-";
    return fmt::format("{}{}", row.value + direction * slack.change, slack.end == SlackEnd::limit ? ", or beyond" : "");
}

constexpr char const* line_format = "  {:<{}} {:>7} {:>22} {:>22}\n";

std::size_t widest_key(std::vector<Sensitivity> const& rows) {
    std::size_t widest = 0;
    for (Sensitivity const& row : rows)
        widest = std::max(widest, row.key.size());
    return widest;
}

/// Of either step, in cycles, whether won or lost; a deadlock is told, but has none.
std::int64_t effect_of(Sensitivity const& row, RunStatistics const& run) {
    std::int64_t largest = 0;
    for (SensitivityStep const* step : {&row.down, &row.up})
        if (finishes(*step))
            largest = std::max(largest, std::abs(change_of(*step, run)));
    return largest;
}

bool is_same_step(SensitivityStep const& a, SensitivityStep const& b) {
    return a.valid == b.valid && a.deadlocks == b.deadlocks && a.needs_run == b.needs_run &&
           a.total_cycles == b.total_cycles;
}

bool has_same_steps(Sensitivity const& a, Sensitivity const& b) {
    return is_same_step(a.down, b.down) && is_same_step(a.up, b.up);
}

bool has_same_slack(Sensitivity const& a, Sensitivity const& b) {
    auto const is_same = [](Slack const& one, Slack const& other) {
        return one.change == other.change && one.end == other.end;
    };
    return is_same(*a.down.slack, *b.down.slack) && is_same(*a.up.slack, *b.up.slack);
}

/// The target of a loop and the interval of its dependence are two keys of one interval: where either step does the
/// same, one row has both.
template <class IsSame> void join_intervals(std::vector<Sensitivity>& rows, IsSame is_same) {
    std::string const target = ".ii";
    std::string const dependence = ".recurrence_ii";
    for (std::size_t i = 1; i < rows.size(); ++i) {
        Sensitivity& first = rows[i - 1];
        Sensitivity const& second = rows[i];
        std::string const loop = first.key.substr(0, first.key.rfind('.'));
        if (first.key == loop + target && second.key == loop + dependence && first.value == second.value &&
            is_same(first, second)) {
            first.key += ", " + dependence.substr(1);
            rows.erase(rows.begin() + static_cast<std::ptrdiff_t>(i));
        }
    }
}

std::string slack_text(RunStatistics const& run) {
    std::string text =
        "\nSlack: how far one key alone may go without costing a cycle, if more of a change never costs less\n";
    std::vector<Sensitivity> rows = run.sensitivities;
    join_intervals(rows, has_same_slack);
    std::size_t const width = widest_key(rows);
    text += fmt::format(line_format, "key", width, "value", "down to", "up to");
    std::size_t tight = 0;
    for (Sensitivity const& row : rows) {
        if (row.down.slack->change == 0 && row.up.slack->change == 0) {
            ++tight;
            continue;
        }
        text += fmt::format(line_format, row.key, width, row.value, slack_cell(row, -1, *row.down.slack),
                            slack_cell(row, 1, *row.up.slack));
    }
    text += fmt::format("  {} {} no slack.\n", tight, tight == 1 ? "key has" : "keys have");
    return text;
}

std::string cell(SensitivityStep const& step, RunStatistics const& run) {
    if (!step.valid)
        return "not valid";
    if (step.deadlocks)
        return "deadlock";
    if (step.needs_run)
        return "needs a run";
    std::int64_t const change = change_of(step, run);
    return fmt::format("{} ({:+.2f} %)", grouped_change(change),
                       100.0 * static_cast<double>(change) / static_cast<double>(run.total_cycles));
}

std::string alternatives_text(RunStatistics const& run) {
    std::string text = "\nAlternatives: change of the total by another choice, exact\n";
    for (Alternative const& row : run.alternatives)
        text += fmt::format("  {:<47} {:>12} -> {:<12} {:>22}\n", row.key, row.value, row.other, cell(row.step, run));
    return text;
}

char const* outcome(SensitivityStep const& step) {
    return !step.valid ? "invalid" : step.deadlocks ? "deadlock" : step.needs_run ? "unknown" : "finished";
}

template <class Value>
void add_csv_row(std::string& text, std::string const& key, Value const& value, Value const& changed,
                 SensitivityStep const& step, RunStatistics const& run) {
    fmt::format_to(std::back_inserter(text), "{},{},{},{},", key, value, changed, outcome(step));
    if (finishes(step))
        fmt::format_to(std::back_inserter(text), "{},{}", step.total_cycles, change_of(step, run));
    else
        text += ',';
    if (step.slack)
        fmt::format_to(std::back_inserter(text), ",{},{}", step.slack->change, enumerator_name(step.slack->end));
    else if (has_slack(run))
        text += ",,";
    text += '\n';
}

Json step_json(SensitivityStep const& step, RunStatistics const& run) {
    Json object = {{"outcome", outcome(step)}};
    if (finishes(step)) {
        object["total_cycles"] = step.total_cycles;
        object["change_cycles"] = change_of(step, run);
    }
    if (step.slack)
        object["slack"] = {{"change", step.slack->change}, {"end", enumerator_name(step.slack->end)}};
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
    std::stable_sort(rows.begin(), rows.end(), [&run](Sensitivity const& a, Sensitivity const& b) {
        return effect_of(a, run) > effect_of(b, run);
    });
    std::size_t const idle = run.sensitivities.size() - rows.size();
    join_intervals(rows, has_same_steps);
    std::size_t const more = rows.size() > most_steps ? rows.size() - most_steps : 0;
    rows.resize(rows.size() - more);
    std::string text = fmt::format("\nSensitivities: change of the {} cycles by one step of one key, exact\n",
                                   grouped(run.total_cycles));
    std::size_t const width = widest_key(rows);
    text += fmt::format(line_format, "key", width, "value", "one less", "one more");
    for (Sensitivity const& row : rows)
        text += fmt::format(line_format, row.key, width, row.value, cell(row.down, run), cell(row.up, run));
    if (more > 0)
        text += fmt::format("  ({} more, which the files of --out or --csv list)\n", more);
    text += fmt::format("  {} {} nothing by one step.\n", idle, idle == 1 ? "key changes" : "keys change");
    if (!run.alternatives.empty())
        text += alternatives_text(run);
    if (has_slack(run))
        text += slack_text(run);
    return text;
}

std::string sensitivities_csv(RunStatistics const& run) {
    std::string text = "key,value,changed_value,outcome,total_cycles,change_cycles";
    text += has_slack(run) ? ",slack,slack_end\n" : "\n";
    for (Sensitivity const& row : run.sensitivities) {
        add_csv_row(text, row.key, row.value, row.value - 1, row.down, run);
        add_csv_row(text, row.key, row.value, row.value + 1, row.up, run);
    }
    for (Alternative const& row : run.alternatives)
        add_csv_row(text, row.key, row.value, row.other, row.step, run);
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

Json alternatives_json(RunStatistics const& run) {
    Json rows = Json::array();
    for (Alternative const& row : run.alternatives) {
        rows.push_back({{"key", row.key}, {"value", row.value}, {"other", row.other}});
        rows.back().update(step_json(row.step, run));
    }
    return rows;
}

std::string sensitivities_file_json(RunStatistics const& run) {
    Json file;
    file["format"] = "faster-sensitivities";
    file["version"] = 1;
    file["total_cycles"] = run.total_cycles;
    file["sensitivities"] = sensitivities_json(run);
    if (!run.alternatives.empty())
        file["alternatives"] = alternatives_json(run);
    return io::text_of(file, 2) + "\n";
}

}  // namespace dataflow::report
