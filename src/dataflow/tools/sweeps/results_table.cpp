#include "dataflow/tools/sweeps/results_table.hpp"

#include <fmt/format.h>
#include <iterator>

#include "dataflow/base/csv_cell.hpp"

namespace dataflow::sweeps {

namespace {

std::string figures(PointResult const& result) {
    if (result.status == PointResult::Status::failed)
        return ",,,,,,,,,";
    std::string const area = fmt::format("{:g},{:.0f},{:.0f},{:.0f}", result.ramb36, result.lut, result.ff, result.dsp);
    if (result.status == PointResult::Status::deadlock)
        return ",,,,,," + area;
    return fmt::format("{},{},{},{},{},{},{}", result.total_cycles, result.milliseconds, result.stall_cycles,
                       result.port_conflict_cycles, result.fifo_full_stall_cycles, result.fifo_empty_stall_cycles,
                       area);
}

}  // namespace

std::vector<std::string> const& result_columns() {
    static std::vector<std::string> const columns{"point",
                                                  "status",
                                                  "total_cycles",
                                                  "milliseconds",
                                                  "stall_cycles",
                                                  "port_conflict_cycles",
                                                  "fifo_full_stall_cycles",
                                                  "fifo_empty_stall_cycles",
                                                  "ramb36",
                                                  "lut",
                                                  "ff",
                                                  "dsp",
                                                  "message"};
    return columns;
}

std::string results_csv(Manifest const& manifest, Results const& results) {
    std::string text = "point";
    for (std::string const& column : manifest.columns)
        text += "," + csv_cell(column);
    for (std::size_t i = 1; i < result_columns().size(); ++i)
        text += "," + result_columns()[i];
    text += "\n";
    for (std::size_t i = 0; i < manifest.points.size(); ++i) {
        auto const found = results.find(manifest.points[i].id);
        if (found == results.end())
            continue;
        text += std::to_string(i);
        for (std::string const& value : manifest.points[i].values)
            text += "," + csv_cell(value);
        fmt::format_to(std::back_inserter(text), ",{},{},{}\n", name_of(found->second.status), figures(found->second),
                       csv_cell(found->second.message));
    }
    return text;
}

}  // namespace dataflow::sweeps
