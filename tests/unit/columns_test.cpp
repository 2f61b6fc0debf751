#include <catch2/catch.hpp>
#include <filesystem>

#include "dataflow/run/figures/column_values.hpp"
#include "dataflow/run/figures/module_row.hpp"
#include "dataflow/run/figures/table_columns.hpp"
#include "faster/data/sample_counters.hpp"
#include "faster/dataflow_names.hpp"
#include "support/temp_folder.hpp"

namespace columns_test {

using namespace faster;

std::string page(std::string const& name) {
    return test::content_of(std::filesystem::path(FASTER_SOURCE_DIR) / "docs" / name);
}

std::string row_of(std::string const& name, ColumnFacts const& column) {
    return "| `" + name + "` | " + column.unit + " | " + column.meaning + " |\n";
}

/// A table of docs/formats.md as it has to be.
template <class Table> std::string rows_of(Table const& columns) {
    std::string rows;
    for (ColumnFacts const& column : columns)
        rows += row_of(column.name, column);
    return rows;
}

std::string without_row_of(std::string rows, std::string const& name) {
    auto const begin = rows.find("| `" + name + "` |");
    return rows.erase(begin, rows.find('\n', begin) + 1 - begin);
}

/// Two columns with names that are no more than that.
struct Thing {
    std::string label;
    std::uint64_t tokens = 0;
    std::uint64_t depth = 0;

    std::uint64_t twice() const { return 2 * tokens; }
    double half() const { return static_cast<double>(depth) / 2; }
    std::string const& name() const { return label; }
};
constexpr Column<Thing> thing_columns[]{
    {"label", "-", &Thing::label, Tells::key, "which"},
    {"tokens", "tokens", &Thing::tokens, Tells::work, "written"},
    {"depth", "cycles", &Thing::depth, Tells::shape, "stages"},
    {"twice", "tokens", &Thing::twice, Tells::work, "both ways"},
    {"half", "-", &Thing::half, Tells::shape, "of the depth"},
};

TEST_CASE("docs/formats.md has the tables of columns word for word", "[columns]") {
    using Catch::Matchers::Contains;
    std::string const formats = page("formats.md");
    CHECK_THAT(formats, Contains(rows_of(sample_columns) + rows_of(sample_counters)));
    CHECK_THAT(formats, Contains(without_row_of(rows_of(fifo_columns), "capacity")));
    CHECK_THAT(formats, Contains(rows_of(loop_columns)));
    CHECK_THAT(formats, Contains(rows_of(memory_columns)));
    std::string classes;
    for (ColumnFacts const& one : cycle_classes)
        classes += row_of(cycles_column(one.name), one);
    CHECK_THAT(formats, Contains(classes));
}

TEST_CASE("docs/budgets.md names every figure of the tables of columns", "[columns]") {
    std::string const budgets = page("budgets.md");
    auto const check = [&budgets](std::string const& table, auto const& columns) {
        auto const begin = budgets.find("| `" + table + ".");
        REQUIRE(begin != std::string::npos);
        std::string const row = budgets.substr(begin, budgets.find('\n', begin) - begin);
        for (ColumnFacts const& column : columns)
            if (column.is_in_budgets() && column.unit != std::string("-"))
                CHECK_THAT(row, Catch::Matchers::Contains("`" + std::string(column.name) + "`"));
    };
    check("samples", sample_columns);
    check("samples", sample_counters);
    check("fifos", fifo_columns);
    check("loops", loop_columns);
    check("brams", memory_columns);
}

TEST_CASE("A column's figures in several cores are summed, or the largest of them stands for all", "[columns]") {
    std::vector<Thing> const all = over_cores(thing_columns, std::vector<Thing>{{"a", 3, 5}, {"b", 1, 1}, {"a", 4, 2}});
    REQUIRE(all.size() == 2);
    CHECK(all[0].label == "a");
    CHECK(all[0].tokens == 7);
    CHECK(all[0].depth == 5);
    CHECK(all[0].twice() == 14);
    CHECK(csv_cells(thing_columns, all[1]) == std::vector<std::string>{"b", "1", "1", "2", "0.500000"});
}

TEST_CASE("Texts and fractions are cells, but no figures", "[columns]") {
    Thing const thing{"a", 3, 5};
    CHECK(cell_in(thing_columns[0], thing) == "a");
    CHECK(cell_in(thing_columns[1], thing) == "3");
    CHECK(figure_in(thing_columns[1], thing) == 3);
    CHECK(figure_in(thing_columns[3], thing) == 6);
    CHECK_FALSE(figure_in(thing_columns[0], thing));
    CHECK_FALSE(figure_in(thing_columns[4], thing));
}

TEST_CASE("Only columns that are stored have a place", "[columns]") {
    Thing thing{"a", 3, 5};
    *place_of<std::uint64_t>(thing_columns[1], thing) = 8;
    CHECK(thing.tokens == 8);
    CHECK(place_of<std::string>(thing_columns[0], thing) == &thing.label);
    CHECK(place_of<std::uint64_t>(thing_columns[0], thing) == nullptr);
    CHECK(place_of<std::uint64_t>(thing_columns[3], thing) == nullptr);
}

}  // namespace columns_test
