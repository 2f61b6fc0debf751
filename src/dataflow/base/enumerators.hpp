#pragma once
#include <array>
#include <cstddef>
#include <string_view>
#include <utility>

namespace dataflow {

/// An enumerator as the source writes it, without its enumeration: "red". The compiler writes a value without a name as
/// a cast, "(Colour)7", of which this is "7".
template <class Enum, Enum value> constexpr std::string_view enumerator_text() {
    std::string_view text = __PRETTY_FUNCTION__;  // "... [with Enum = Colour; Enum value = Colour::red; ...]"
    text.remove_prefix(text.rfind("value = ") + 8);
    text = text.substr(0, text.find_first_of(";]"));
    return text.substr(text.find_last_of(":)") + 1);
}

/// Whether an enumeration names a value.
template <class Enum, Enum value> constexpr bool is_enumerator() {
    constexpr char first = enumerator_text<Enum, value>().front();
    return first != '-' && (first < '0' || first > '9');
}

/// How many enumerators there are that count from 0 on: the size of a table that is indexed by them.
template <class Enum, std::size_t first = 0> constexpr std::size_t enum_size() {
    if constexpr (is_enumerator<Enum, static_cast<Enum>(first)>())
        return enum_size<Enum, first + 1>();
    else
        return first;
}

template <class Enum, std::size_t... value>
constexpr std::array<std::string_view, sizeof...(value)> enumerator_texts(std::index_sequence<value...>) {
    return {enumerator_text<Enum, static_cast<Enum>(value)>()...};
}

/// The enumerators of an enumeration that counts from 0 on, as files and reports write them.
template <class Enum>
constexpr auto enumerator_names = enumerator_texts<Enum>(std::make_index_sequence<enum_size<Enum>()>());

template <class Enum> constexpr std::string_view enumerator_name(Enum value) {
    return enumerator_names<Enum>[static_cast<std::size_t>(value)];
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
