#include "kernel/budgets/run_figures.hpp"

#include <algorithm>

#include "kernel/config/design.hpp"
#include "kernel/figures/column_values.hpp"
#include "kernel/figures/table_rows.hpp"

namespace faster::budgets {

namespace {

/// Adds figures below a common beginning of their names.
class Section {
  public:
    Section(Figures& figures, std::string prefix) : figures_(figures), prefix_(std::move(prefix)) {}

    void set(std::string const& name, std::uint64_t value) { figures_.set(prefix_ + name, value); }
    void set(std::string const& list, std::vector<NamedCycles> const& all) {
        for (NamedCycles const& one : all)
            set(list + one.name, one.cycles);
    }
    template <class Row> void set(Column<Row> const& column, Row const& row) {
        std::optional<std::uint64_t> const figure = figure_in(column, row);
        if (column.is_in_budgets() && figure)
            set(column.name, *figure);
    }

  private:
    Figures& figures_;
    std::string prefix_;
};

/// What the tables of a run say, of every core or of all together.
struct Rows {
    std::vector<ModuleRow> modules;
    std::vector<FifoRow> fifos;
    std::vector<MemoryRow> memories;
    std::vector<LoopRow> loops;
};

void add_row(Figures& figures, std::string const& table, ModuleRow const& module) {
    Section section(figures, table + module.module + ".");
    for (std::size_t c = 0; c < cycle_class_count; ++c)
        if (module.has_class(c))
            section.set(cycles_column(cycle_class_names[c]), module.cycles[c]);
    section.set("stalls.", module.stalls);
    section.set("port_conflicts.", module.port_conflicts);
}

template <class Row, std::size_t N>
void add_rows(Figures& figures, std::string const& table, Columns<Row, N> columns, std::vector<Row> const& rows,
              std::size_t core) {
    for (Row const& row : rows) {
        if (row.core != core)
            continue;
        Section section(figures, table + row.name() + ".");
        for (Column<Row> const& column : columns)
            section.set(column, row);
    }
}

void add_core(Figures& figures, std::string const& prefix, Rows const& rows, std::size_t core) {
    for (ModuleRow const& module : rows.modules)
        if (module.core == core)
            add_row(figures, prefix + "modules.", module);
    add_rows(figures, prefix + "fifos.", fifo_columns, rows.fifos, core);
    add_rows(figures, prefix + "brams.", memory_columns, rows.memories, core);
    add_rows(figures, prefix + "loops.", loop_columns, rows.loops, core);
}

void add_sample(Figures& figures, SampleStatistics const& sample) {
    Section section(figures, "samples." + std::to_string(sample.sample) + ".");
    for (auto const& column : sample_columns)
        section.set(column, sample);
    for (std::size_t i = 0; i < sample.counters.size(); ++i)
        section.set(design().counters()[i].name, sample.counters[i]);
}

}  // namespace

Figures run_figures(RunStatistics const& run) {
    Figures figures;
    figures.set("total_cycles", run.total_cycles);
    figures.set("samples", run.samples.size());
    figures.set("raster_cores", run.cores.size());
    std::vector<MemoryRow> memories = memory_rows(run);
    auto const waits_for_none = [](MemoryRow const& memory) { return !memory.decides_intervals; };
    memories.erase(std::remove_if(memories.begin(), memories.end(), waits_for_none), memories.end());
    Rows const rows{module_rows(run), fifo_rows(run), memories, loop_rows(run)};
    Rows const sums{module_sums(run), over_cores(fifo_columns, rows.fifos), over_cores(memory_columns, rows.memories),
                    over_cores(loop_columns, rows.loops)};
    add_core(figures, "", sums, 0);
    for (SampleStatistics const& sample : run.samples)
        add_sample(figures, sample);
    for (std::size_t core = 0; core < run.cores.size(); ++core)
        add_core(figures, "cores." + std::to_string(core) + ".", rows, core);
    return figures;
}

}  // namespace faster::budgets
