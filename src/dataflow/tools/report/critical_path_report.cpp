#include "dataflow/tools/report/critical_path_report.hpp"

#include <fmt/format.h>
#include <iterator>

#include "dataflow/base/enumerators.hpp"
#include "dataflow/base/grouped_digits.hpp"

namespace dataflow::report {

namespace {

constexpr std::size_t most_rows = 12;

std::string item_of(Machine const& machine, PathRow const& row) {
    return row.fifo ? machine.fifos[*row.fifo].name : row.bram;
}
std::string loop_of(Machine const& machine, PathRow const& row) {
    return row.loop ? machine.loops[*row.loop].name : std::string();
}

void add_line(std::string& text, RunStatistics const& run, PathRow const& row) {
    Machine const& machine = run.machine;
    std::string const item = item_of(machine, row);
    std::string const cause = std::string(enumerator_name(row.cause)) + (item.empty() ? "" : " " + item);
    std::string const place =
        machine.processes[row.module].name + (row.loop ? "." + loop_of(machine, row) : std::string());
    fmt::format_to(std::back_inserter(text), "  {:<27} {:<28} {:>13} {:>7.2f}\n", place, cause, grouped(row.cycles),
                   100.0 * static_cast<double>(row.cycles) / static_cast<double>(run.core_cycles()));
}

}  // namespace

std::string critical_path_text(RunStatistics const& run) {
    if (!run.critical_path || run.critical_path->rows.empty())
        return "";
    std::vector<PathRow> const& rows = run.critical_path->rows;
    std::string text = fmt::format("\nCritical path of core {}, the last to end: how its {} cycles came about\n",
                                   run.critical_path->core, grouped(run.core_cycles()));
    text += fmt::format("  {:<27} {:<28} {:>13} {:>7}\n", "module.loop", "cause", "cycles", "%");
    for (std::size_t i = 0; i < rows.size() && i < most_rows; ++i)
        add_line(text, run, rows[i]);
    if (rows.size() > most_rows) {
        Cycles rest = 0;
        for (std::size_t i = most_rows; i < rows.size(); ++i)
            rest += rows[i].cycles;
        text += fmt::format("  {:<56} {:>13}\n", fmt::format("({} more in summary.json)", rows.size() - most_rows),
                            grouped(rest));
    }
    return text;
}

Json critical_path_json(RunStatistics const& run) {
    Json rows = Json::array();
    for (PathRow const& row : run.critical_path->rows)
        rows.push_back({{"module", run.machine.processes[row.module].name},
                        {"loop", loop_of(run.machine, row)},
                        {"cause", enumerator_name(row.cause)},
                        {"item", item_of(run.machine, row)},
                        {"cycles", row.cycles},
                        {"crossings", row.crossings}});
    return {{"core", run.critical_path->core}, {"rows", rows}};
}

}  // namespace dataflow::report
