#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

namespace dataflow {

/// What a column tells of its row.
enum class Tells {
    key,      ///< which row it is
    shape,    ///< how the thing is built
    when,     ///< a cycle of the run, or a span of them
    work,     ///< what was done; the same amount however quickly
    waiting,  ///< cycles in which nothing could be done
    peak,     ///< the most that was there at once
    result,   ///< what was computed
};

/// Where a column is written. What CSV files have is read back from a finished run.
enum class WrittenTo {
    all,  ///< CSV, JSON and budgets
    json_and_budgets,
    json,
};

/// All that the tables of figures have to know about a column, whatever its rows are.
struct ColumnFacts {
    char const* name;
    char const* unit;  ///< "-": none
    Tells tells;
    char const* meaning;                ///< for docs/formats.md
    char const* compared_in = nullptr;  ///< the list of a comparison in which its changes are told
    WrittenTo written = WrittenTo::all;

    /// Whether the figures of several cores add up. Otherwise the largest stands for all.
    bool is_summed() const { return tells == Tells::work || tells == Tells::waiting || tells == Tells::result; }
    bool is_in_csv() const { return written == WrittenTo::all; }
    /// A column of figures; keys and texts are no figures.
    bool is_in_budgets() const { return tells != Tells::key && written != WrittenTo::json; }
    bool is_compared_in(std::string_view list) const { return compared_in != nullptr && compared_in == list; }
    /// Counted in clock cycles: a limit on it may be a time too.
    bool is_in_cycles() const { return std::string_view(unit).substr(0, 5) == "cycle"; }
};

/// A column and where its figure stands in a row.
template <class Row> struct Column : ColumnFacts {
    /// Functions are for what follows from other columns.
    using Member =
        std::variant<std::uint64_t Row::*, std::string Row::*, std::uint64_t (Row::*)() const, double (Row::*)() const>;
    Member member;

    constexpr Column(char const* its_name, char const* its_unit, Member its_member, Tells what, char const* its_meaning,
                     char const* its_list = nullptr, WrittenTo where = WrittenTo::all)
        : ColumnFacts{its_name, its_unit, what, its_meaning, its_list, where}, member(its_member) {}
};

}  // namespace dataflow
