#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "dataflow/run/figures/run_statistics.hpp"

namespace dataflow::report {

/// How long a recorded run would take in each of several configurations: a row for each.
class WhatifTable {
  public:
    /// The recorded run: what the rows are compared with.
    WhatifTable(Machine const& recorded, Cycles total_cycles);

    /// `settings` says what the configuration changes.
    void add_row(std::string settings, Machine const& machine);
    /// None: a non-blocking access might find something else than in the recorded run, and only a run can tell.
    void set_result(std::size_t row, std::optional<RunStatistics> const& run);

    /// For people; and as docs/formats.md has it ("The table of whatif --matrix").
    std::string text() const;
    std::string csv() const;

  private:
    struct Row {
        std::string settings;
        double clock_mhz = 0;
        std::string outcome;
        Cycles total_cycles = 0;

        double milliseconds() const { return static_cast<double>(total_cycles) / (clock_mhz * 1e3); }
    };
    std::int64_t change_of(Row const& row) const;

    Row recorded_;
    std::vector<Row> rows_;
};

}  // namespace dataflow::report
