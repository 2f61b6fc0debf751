#include "kernel/budgets/figure_facts.hpp"

#include <algorithm>
#include <iterator>

#include "kernel/budgets/figures.hpp"
#include "kernel/config/design.hpp"
#include "kernel/figures/fifo_columns.hpp"
#include "kernel/figures/loop_columns.hpp"
#include "kernel/figures/memory_columns.hpp"
#include "kernel/figures/module_row.hpp"
#include "kernel/figures/sample_columns.hpp"

namespace faster::budgets {

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

}  // namespace

ColumnFacts const& facts_of(std::string const& name) {
    std::vector<std::string> const parts = parts_of(name);
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

}  // namespace faster::budgets
