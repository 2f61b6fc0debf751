#include "dataflow/tools/budgets/starting_budget.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "dataflow/base/files/json_file.hpp"
#include "dataflow/base/files/yaml_document.hpp"
#include "dataflow/base/program_name.hpp"
#include "dataflow/run/config/keys.hpp"
#include "dataflow/tools/budgets/baseline_text.hpp"
#include "dataflow/tools/budgets/figure_pattern.hpp"

namespace dataflow::budgets {

namespace {

constexpr int slack = 2;  // percent

std::string quoted(std::string const& text) { return io::text_of(text); }

/// A list is YAML in the command line too.
std::string setting_line(std::string const& name, std::string const& value) {
    Key const* const key = find_key(name);
    bool const is_list = key != nullptr && (key->kind == KeyKind::vector || key->kind == KeyKind::items);
    bool const is_line = value.find_first_of("\r\n") == std::string::npos;
    return fmt::format("  {}: {}\n", name, is_list && is_line ? value : yaml_value(value));
}

std::string head(Budget const& budget, std::string const& date) {
    std::string const name = budget.file.filename().string();
    std::string text = fmt::format(
        "# Latency budget, started from a run on {0} ({3} check --init).\n"
        "#   {3} check {1}   exit code 1 if a limit is broken\n"
        "#   {3} check {1} --update --reason \"why\"   takes today's figures as the baseline\n"
        "# Figures, limits and wildcards: docs/budgets.md, \"What can be limited\".\n"
        "format: faster-budget\nversion: 1\nconfiguration: {2}  # relative to this file\n",
        date, name, quoted(budget.configuration), program_name());
    if (!budget.trace.empty())
        text += fmt::format("trace: {}  # replayed instead of the configured workload\n", quoted(budget.trace));
    if (!budget.overrides.empty())
        text += "set:  # wins over the configuration\n";
    for (std::string const& setting : budget.overrides) {
        std::size_t const equals = setting.find('=');
        text += setting_line(setting.substr(0, equals), setting.substr(equals + 1));
    }
    return text;
}

/// So many digits that rounding up adds less than a thousandth: the slack is what a limit leaves room for.
std::string rounded_up(double microseconds) {
    int const decimals =
        microseconds <= 0 ? 0 : std::max(0, 3 - static_cast<int>(std::floor(std::log10(microseconds))));
    double const scale = std::pow(10, decimals);
    return fmt::format("{:.{}f}", std::ceil(microseconds * scale) / scale, decimals);
}

std::string limit_lines(Measurement const& measurement, GuardedFigures const& guarded) {
    auto const total = static_cast<double>(measurement.figures.find("total_cycles").value_or(0));
    std::string text = fmt::format(
        "\nlimits:\n"
        "  # The whole run: {:.0f} cycles today. A time counts at accelerator.clock_mhz; slack is what may come on "
        "top, in percent.\n"
        "  total_cycles: {{max: {} us, slack: {}}}\n",
        total, rounded_up(total / measurement.clock_mhz), slack);
    if (measurement.figures.find("samples").value_or(0) > 0)
        text += fmt::format(
            "  # No sample takes longer than it does today{}.\n"
            "  samples.*.latency_cycles: {{max: baseline, slack: {}}}\n{}",
            guarded.counter.empty() ? "" : ", and none may score differently", slack,
            guarded.counter.empty() ? "" : fmt::format("  samples.*.{}: {{exact: baseline}}\n", guarded.counter));
    if (FigurePattern("loops.*.*.ii").matches_any(measurement.figures))
        text +=
            "  # Every loop keeps its initiation interval; loops.MODULE.LOOP.\n"
            "  loops.*.*.ii: {max: baseline}\n";
    text += fmt::format(
        "  # Waiting may move by as much. Figures without cores.N. are sums over all cores, occupancies the largest.\n"
        "  modules.{}.empty_stall_cycles: {{within: {{of: baseline, percent: {}}}}}\n"
        "{}"
        "  # To guard every cycle of every FIFO, loop and module instead:\n"
        "  # fifos.*.*: {{exact: baseline}}\n"
        "  # loops.*.*.*: {{exact: baseline}}\n"
        "  # modules.*.*: {{exact: baseline}}\n\n",
        guarded.module, slack,
        FigurePattern("fifos.*.max_occupancy").matches_any(measurement.figures)
            ? "  fifos.*.max_occupancy: {max: baseline}\n"
            : "");
    return text;
}

}  // namespace

std::string starting_budget(Budget const& budget, Measurement const& measurement, GuardedFigures const& guarded,
                            std::string const& date) {
    // Figures of samples that limit_lines() compares with the baseline.
    std::vector<Limit> compared(guarded.counter.empty() ? 1 : 2);
    compared[0].figure = "samples.*.latency_cycles";
    if (!guarded.counter.empty())
        compared[1].figure = "samples.*." + guarded.counter;
    for (Limit& limit : compared)
        limit.max = Quantity{Quantity::Kind::baseline, 0, "baseline"};
    return head(budget, date) + limit_lines(measurement, guarded) +
           baseline_block(baseline_of(measurement, compared, date, "first run"));
}

}  // namespace dataflow::budgets
