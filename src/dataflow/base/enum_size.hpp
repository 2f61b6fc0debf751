#pragma once
#include <cstddef>
#include <string_view>

namespace dataflow {

/// Whether an enumeration names a value: the compiler writes a value without a name as a cast, "(Colour)7".
template <class Enum, Enum value> constexpr bool is_enumerator() {
    constexpr std::string_view text = __PRETTY_FUNCTION__;
    constexpr std::size_t begin = text.rfind("value = ") + 8;
    return text[begin] != '(' && text[begin] != '-' && (text[begin] < '0' || text[begin] > '9');
}

/// How many enumerators there are that count from 0 on: the size of a table that is indexed by them.
template <class Enum, std::size_t first = 0> constexpr std::size_t enum_size() {
    if constexpr (is_enumerator<Enum, static_cast<Enum>(first)>())
        return enum_size<Enum, first + 1>();
    else
        return first;
}

/// Whether row i of a table of rows is about enumerator i, and every enumerator has one; `about` finds a row's.
template <class Enum, class Table, class About> constexpr bool has_a_row_for_each(Table const& table, About about) {
    if (table.size() != enum_size<Enum>())
        return false;
    for (std::size_t i = 0; i < table.size(); ++i)
        if (about(table[i]) != static_cast<Enum>(i))
            return false;
    return true;
}

}  // namespace dataflow
