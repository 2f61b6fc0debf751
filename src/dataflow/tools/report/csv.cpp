#include "dataflow/tools/report/csv.hpp"

#include <fmt/format.h>

#include "dataflow/run/config/design.hpp"
#include "dataflow/run/figures/column_values.hpp"
#include "dataflow/run/figures/table_rows.hpp"

namespace dataflow::report {

namespace {

std::string line(std::vector<std::string> const& cells) { return fmt::format("{}\n", fmt::join(cells, ",")); }

std::string sample_line(SampleStatistics const& sample) {
    std::vector<std::string> cells = csv_cells(sample_columns, sample);
    for (std::uint64_t const counter : sample.counters)
        cells.push_back(std::to_string(counter));
    return line(cells);
}

std::string loop_lines(RunStatistics const& run, bool is_in_csv) {
    std::string text;
    for (LoopRow const& row : loop_rows(run))
        if (design().leaves_out_of_loops_csv(row.name()) != is_in_csv)
            text += line(csv_cells(loop_columns, row));
    return text;
}

}  // namespace

std::string samples_csv(RunStatistics const& run, RunConfig const& config) {
    std::vector<std::string> header = csv_header(sample_columns);
    std::vector<ColumnFacts> const& counters = design().counters();
    std::size_t const count = run.samples.empty() ? design().counters_of(config) : run.samples.front().counters.size();
    for (std::size_t i = 0; i < count; ++i)
        header.emplace_back(counters[i].name);
    std::string text = line(header);
    for (SampleStatistics const& sample : run.samples)
        text += sample_line(sample);
    return text;
}

std::string fifos_csv(RunStatistics const& run) {
    std::string text = line(csv_header(fifo_columns));
    for (FifoRow const& row : fifo_rows(run))
        text += line(csv_cells(fifo_columns, row));
    return text;
}

std::string loops_csv(RunStatistics const& run) { return line(csv_header(loop_columns)) + loop_lines(run, true); }

std::string all_loops_csv(RunStatistics const& run) { return loops_csv(run) + loop_lines(run, false); }

}  // namespace dataflow::report
