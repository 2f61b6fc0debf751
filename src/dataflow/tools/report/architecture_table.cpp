#include "dataflow/tools/report/architecture_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <nlohmann/json.hpp>

#include "dataflow/base/csv_cell.hpp"
#include "dataflow/base/files/json_file.hpp"
#include "dataflow/tools/report/summary.hpp"
#include "dataflow/tools/resources/machine_resources.hpp"

namespace dataflow::report {

namespace {

using Rows = std::vector<ArchitectureRow>;

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

bool has_quality(Rows const& rows) {
    return std::any_of(rows.begin(), rows.end(), [](ArchitectureRow const& row) { return row.judged_samples > 0; });
}

/// Cells with the quality of the results of an architecture, every sample counting once.
std::string quality_cells(Rows::const_iterator begin, Rows::const_iterator end) {
    std::size_t samples = 0;
    std::array<double, 4> sums{};
    for (auto row = begin; row != end; ++row) {
        std::array<double, 4> const means{row->precision, row->recall, row->closed, row->thin};
        for (std::size_t i = 0; i < sums.size(); ++i)
            sums[i] += means[i] * static_cast<double>(row->judged_samples);
        samples += row->judged_samples;
    }
    std::string cells;
    for (double const sum : sums)
        cells += samples > 0 ? fmt::format(" {:.1f} % |", 100 * sum / static_cast<double>(samples)) : " - |";
    return cells;
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
    line += fmt::format(" {} | {:g} | {:.0f} | {:.0f} | {:.0f} |", conflicts, begin->ramb36, begin->lut, begin->ff,
                        begin->dsp);
    return line + (has_quality(rows) ? quality_cells(begin, end) : "") + "\n";
}

}  // namespace

ArchitectureRow architecture_row(RunStatistics const& run) {
    ArchitectureRow row;
    row.deadlocked = run.deadlocked();
    row.ramb36 = ramb36_of_core(run.machine) * static_cast<double>(run.machine.cores);
    Resources const cores = resources_of(run.machine).cores.amount;
    row.lut = cores.lut;
    row.ff = cores.ff;
    row.dsp = cores.dsp;
    if (row.deadlocked)
        return row;
    row.total_cycles = run.total_cycles;
    row.milliseconds = run.machine.milliseconds(run.total_cycles);
    for (std::size_t i = 0; i < run.machine.processes.size(); ++i) {
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
    bool const judged = has_quality(rows);
    std::string text = header + " time, first = 1 | port conflict cycles | RAMB36 | LUT | FF | DSP |" +
                       (judged ? " precision | recall | closed | thin |\n" : "\n") + rule +
                       " --- | --- | --- | --- | --- | --- |" + (judged ? " --- | --- | --- | --- |\n" : "\n");
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
        "port_conflict_cycles,ramb36,judged_samples,precision,recall,closed,thin,lut,ff,dsp\n";
    for (ArchitectureRow const& row : rows) {
        fmt::format_to(std::back_inserter(text), "{},{},{},", csv_cell(row.architecture), csv_cell(row.workload),
                       row.deadlocked ? "deadlock" : "finished");
        if (row.deadlocked)
            text += ",,,,";
        else
            fmt::format_to(std::back_inserter(text), "{},{:.6f},{},{},{}", row.total_cycles, row.milliseconds,
                           row.empty_stall_cycles, row.full_stall_cycles, row.port_conflict_cycles);
        fmt::format_to(std::back_inserter(text), ",{:g},{},", row.ramb36, row.judged_samples);
        if (row.judged_samples == 0)
            text += ",,,";
        else
            fmt::format_to(std::back_inserter(text), "{:.4f},{:.4f},{:.4f},{:.4f}", row.precision, row.recall,
                           row.closed, row.thin);
        fmt::format_to(std::back_inserter(text), ",{:.0f},{:.0f},{:.0f}\n", row.lut, row.ff, row.dsp);
    }
    return text;
}

std::string to_text(ArchitectureRow const& row) {
    return io::text_of(nlohmann::json{{"deadlocked", row.deadlocked},
                                      {"total_cycles", row.total_cycles},
                                      {"milliseconds", row.milliseconds},
                                      {"empty_stall_cycles", row.empty_stall_cycles},
                                      {"full_stall_cycles", row.full_stall_cycles},
                                      {"port_conflict_cycles", row.port_conflict_cycles},
                                      {"ramb36", row.ramb36},
                                      {"lut", row.lut},
                                      {"ff", row.ff},
                                      {"dsp", row.dsp},
                                      {"judged_samples", row.judged_samples},
                                      {"precision", row.precision},
                                      {"recall", row.recall},
                                      {"closed", row.closed},
                                      {"thin", row.thin}});
}

ArchitectureRow row_from_text(std::string const& text) {
    nlohmann::json const json = nlohmann::json::parse(text);
    ArchitectureRow row;
    json.at("deadlocked").get_to(row.deadlocked);
    json.at("total_cycles").get_to(row.total_cycles);
    json.at("milliseconds").get_to(row.milliseconds);
    json.at("empty_stall_cycles").get_to(row.empty_stall_cycles);
    json.at("full_stall_cycles").get_to(row.full_stall_cycles);
    json.at("port_conflict_cycles").get_to(row.port_conflict_cycles);
    json.at("ramb36").get_to(row.ramb36);
    json.at("lut").get_to(row.lut);
    json.at("ff").get_to(row.ff);
    json.at("dsp").get_to(row.dsp);
    json.at("judged_samples").get_to(row.judged_samples);
    json.at("precision").get_to(row.precision);
    json.at("recall").get_to(row.recall);
    json.at("closed").get_to(row.closed);
    json.at("thin").get_to(row.thin);
    return row;
}

}  // namespace dataflow::report
