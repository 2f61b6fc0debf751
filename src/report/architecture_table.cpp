#include "report/architecture_table.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <nlohmann/json.hpp>

#include "config/block_ram.hpp"
#include "report/summary.hpp"

namespace faster::report {

namespace {

using Json = nlohmann::json;
using Rows = std::vector<ArchitectureRow>;

double ramb36_of_core(AcceleratorConfig const& config) {
    double sum = ramb36_count(line_buffer_shape(config));
    for (std::size_t i = 0; i < bram_count; ++i)
        sum += ramb36_count(memory_shape(static_cast<BramId>(i), config));
    return sum;
}

/// The rows from `begin` on that are of one architecture.
Rows::const_iterator end_of_architecture(Rows const& rows, Rows::const_iterator begin) {
    return std::find_if(begin, rows.end(),
                        [begin](ArchitectureRow const& row) { return row.architecture != begin->architecture; });
}

/// Geometric mean of the times against those of the first architecture; 0 if there is no workload that both finish.
double relative_time(Rows::const_iterator first, Rows::const_iterator begin, Rows::const_iterator end) {
    double logarithms = 0;
    int count = 0;
    for (; begin != end; ++begin, ++first) {
        if (begin->deadlocked || first->deadlocked || begin->milliseconds <= 0 || first->milliseconds <= 0)
            continue;
        logarithms += std::log(begin->milliseconds / first->milliseconds);
        ++count;
    }
    return count == 0 ? 0 : std::exp(logarithms / count);
}

std::string line_of(Rows const& rows, Rows::const_iterator begin, Rows::const_iterator end) {
    std::string line = fmt::format("| {} |", begin->architecture);
    for (auto row = begin; row != end; ++row)
        line += row->deadlocked ? " deadlock |" : fmt::format(" {:.2f} |", row->milliseconds);
    double const relative = relative_time(rows.begin(), begin, end);
    line += relative > 0 ? fmt::format(" {:.2f} |", relative) : " - |";
    Cycles conflicts = 0;
    for (auto row = begin; row != end; ++row)
        conflicts += row->port_conflict_cycles;
    return line + fmt::format(" {} | {:g} |\n", conflicts, begin->ramb36);
}

}  // namespace

ArchitectureRow architecture_row(AcceleratorConfig const& config, RunStatistics const& run) {
    ArchitectureRow row;
    row.deadlocked = run.deadlocked();
    row.ramb36 = ramb36_of_core(config) * static_cast<double>(config.raster_cores);
    if (row.deadlocked)
        return row;
    row.total_cycles = run.total_cycles;
    row.milliseconds = milliseconds(run.total_cycles, config);
    for (std::size_t i = 0; i < module_count; ++i) {
        ProcessStatistics const process = process_sum(run, i);
        row.empty_stall_cycles += process[CycleClass::empty_stall];
        row.full_stall_cycles += process[CycleClass::full_stall];
        row.port_conflict_cycles += process[CycleClass::port_conflict];
    }
    return row;
}

std::string architecture_markdown(Rows const& rows) {
    if (rows.empty())
        return "";
    std::string header = "| ms |";
    std::string rule = "| --- |";
    for (auto row = rows.begin(); row != end_of_architecture(rows, rows.begin()); ++row) {
        header += fmt::format(" {} |", row->workload);
        rule += " --- |";
    }
    std::string text = header + " time, first = 1 | port conflict cycles | RAMB36 |\n" + rule + " --- | --- | --- |\n";
    for (auto begin = rows.begin(); begin != rows.end();) {
        auto const end = end_of_architecture(rows, begin);
        text += line_of(rows, begin, end);
        begin = end;
    }
    return text;
}

std::string architecture_csv(Rows const& rows) {
    std::string text =
        "architecture,workload,outcome,total_cycles,milliseconds,empty_stall_cycles,full_stall_cycles,"
        "port_conflict_cycles,ramb36\n";
    for (ArchitectureRow const& row : rows) {
        fmt::format_to(std::back_inserter(text), "{},{},{},", row.architecture, row.workload,
                       row.deadlocked ? "deadlock" : "finished");
        if (row.deadlocked)
            text += ",,,,";
        else
            fmt::format_to(std::back_inserter(text), "{},{:.6f},{},{},{}", row.total_cycles, row.milliseconds,
                           row.empty_stall_cycles, row.full_stall_cycles, row.port_conflict_cycles);
        fmt::format_to(std::back_inserter(text), ",{:g}\n", row.ramb36);
    }
    return text;
}

std::string to_text(ArchitectureRow const& row) {
    return Json{{"deadlocked", row.deadlocked},
                {"total_cycles", row.total_cycles},
                {"milliseconds", row.milliseconds},
                {"empty_stall_cycles", row.empty_stall_cycles},
                {"full_stall_cycles", row.full_stall_cycles},
                {"port_conflict_cycles", row.port_conflict_cycles},
                {"ramb36", row.ramb36}}
        .dump();
}

ArchitectureRow row_from_text(std::string const& text) {
    Json const json = Json::parse(text);
    ArchitectureRow row;
    json.at("deadlocked").get_to(row.deadlocked);
    json.at("total_cycles").get_to(row.total_cycles);
    json.at("milliseconds").get_to(row.milliseconds);
    json.at("empty_stall_cycles").get_to(row.empty_stall_cycles);
    json.at("full_stall_cycles").get_to(row.full_stall_cycles);
    json.at("port_conflict_cycles").get_to(row.port_conflict_cycles);
    json.at("ramb36").get_to(row.ramb36);
    return row;
}

}  // namespace faster::report
