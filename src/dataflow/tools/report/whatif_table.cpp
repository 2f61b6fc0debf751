#include "dataflow/tools/report/whatif_table.hpp"

#include <fmt/format.h>
#include <iterator>
#include <utility>

#include "dataflow/base/csv_cell.hpp"
#include "dataflow/base/grouped_digits.hpp"

namespace dataflow::report {

namespace {
constexpr char const* finished = "finished";
constexpr char const* unknown = "unknown";
}  // namespace

WhatifTable::WhatifTable(Machine const& recorded, Cycles total_cycles) {
    recorded_.settings = "as recorded";
    recorded_.clock_mhz = recorded.clock_mhz;
    recorded_.total_cycles = total_cycles;
}

void WhatifTable::add_row(std::string settings, Machine const& machine) {
    rows_.push_back({std::move(settings), machine.clock_mhz, "", 0});
}

void WhatifTable::set_result(std::size_t row, std::optional<RunStatistics> const& run) {
    rows_[row].outcome = !run ? unknown : run->deadlocked() ? "deadlock" : finished;
    rows_[row].total_cycles = run ? run->total_cycles : 0;
}

std::int64_t WhatifTable::change_of(Row const& row) const {
    return static_cast<std::int64_t>(row.total_cycles) - static_cast<std::int64_t>(recorded_.total_cycles);
}

std::string WhatifTable::text() const {
    std::string text =
        fmt::format("  {:>5} {:>14} {:>12} {:>22}  configuration\n", "row", "total cycles", "ms", "change");
    fmt::format_to(std::back_inserter(text), "  {:>5} {:>14} {:>12.3f} {:>22}  {}\n", "-",
                   grouped(recorded_.total_cycles), recorded_.milliseconds(), "-", recorded_.settings);
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        Row const& row = rows_[i];
        if (row.outcome != finished) {
            fmt::format_to(std::back_inserter(text), "  {:>5} {:>14} {:>12} {:>22}  {}\n", i,
                           row.outcome == unknown ? "needs a run" : row.outcome, "-", "-", row.settings);
            continue;
        }
        std::string change = fmt::format("{}", grouped_change(change_of(row)));
        if (recorded_.total_cycles > 0)
            change += fmt::format(" ({:+.2f} %)", 100.0 * static_cast<double>(change_of(row)) /
                                                      static_cast<double>(recorded_.total_cycles));
        fmt::format_to(std::back_inserter(text), "  {:>5} {:>14} {:>12.3f} {:>22}  {}\n", i, grouped(row.total_cycles),
                       row.milliseconds(), change, row.settings);
    }
    return text;
}

std::string WhatifTable::csv() const {
    std::string text = "row,configuration,outcome,total_cycles,milliseconds,change_cycles\n";
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        Row const& row = rows_[i];
        if (row.outcome != finished)
            fmt::format_to(std::back_inserter(text), "{},{},{},,,\n", i, csv_cell(row.settings), row.outcome);
        else
            fmt::format_to(std::back_inserter(text), "{},{},finished,{},{},{}\n", i, csv_cell(row.settings),
                           row.total_cycles, row.milliseconds(), change_of(row));
    }
    return text;
}

}  // namespace dataflow::report
