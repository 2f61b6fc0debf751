#include "dataflow/tools/budgets/figures.hpp"

#include <algorithm>
#include <iterator>

#include "dataflow/base/text_lines.hpp"
#include "dataflow/run/config/design.hpp"
#include "dataflow/run/figures/column_values.hpp"
#include "dataflow/run/figures/module_row.hpp"
#include "dataflow/run/figures/table_columns.hpp"
#include "dataflow/run/figures/table_rows.hpp"

namespace dataflow::budgets {

namespace {

constexpr ColumnFacts unknown{"", "-", Tells::work, ""};
constexpr ColumnFacts cycles_by_cause{"", "cycles", Tells::waiting, "by FIFO or by block RAM"};
constexpr ColumnFacts run_columns[]{
    {"total_cycles", "cycles", Tells::when, "how long the run takes"},
    {"samples", "-", Tells::shape, "how many there are"},
    {"raster_cores", "-", Tells::shape, "how many there are"},
};

template <class Table> ColumnFacts const& column_of(Table const& columns, std::string const& name) {
    auto const found = std::find_if(std::begin(columns), std::end(columns), [&name](ColumnFacts const& column) {
        return column.name == name && column.is_in_budgets();
    });
    return found == std::end(columns) ? unknown : *found;
}

ColumnFacts const& class_of(std::string const& name) {
    auto const found = std::find_if(std::begin(cycle_classes), std::end(cycle_classes),
                                    [&name](ColumnFacts const& one) { return cycles_column(one.name) == name; });
    return found == std::end(cycle_classes) ? unknown : *found;
}

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

ColumnFacts const& facts_of(std::string const& name) {
    std::vector<std::string> const parts = split_at_points(name);
    std::size_t const first = parts.size() > 2 && parts[0] == "cores" ? 2 : 0;
    std::string const& table = parts[first];
    std::string const& figure = parts.back();
    if (parts.size() == 1)
        return column_of(run_columns, figure);
    if (table == "modules")
        return parts.size() == first + 4 ? cycles_by_cause : class_of(figure);
    if (table == "fifos")
        return column_of(fifo_columns, figure);
    if (table == "brams")
        return column_of(memory_columns, figure);
    if (table == "loops")
        return column_of(loop_columns, figure);
    ColumnFacts const& counter = column_of(design().counters(), figure);
    return &counter == &unknown ? column_of(sample_columns, figure) : counter;
}

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

void Figures::set(std::string const& name, std::uint64_t value) {
    auto const [found, is_new] = index_.try_emplace(name, all_.size());
    if (is_new)
        all_.push_back({name, value});
    all_[found->second].value = value;
}

std::optional<std::uint64_t> Figures::find(std::string const& name) const {
    auto const found = index_.find(name);
    return found == index_.end() ? std::nullopt : std::optional(all_[found->second].value);
}

}  // namespace dataflow::budgets
