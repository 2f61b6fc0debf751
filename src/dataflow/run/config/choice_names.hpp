#pragma once
#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "dataflow/base/enumerators.hpp"
#include "dataflow/core/machine/fifo_kind.hpp"

namespace dataflow {

/// How the enumerators of a choice are written in configuration files and reports, in their order.
template <class Enum> constexpr auto choice_names = enumerator_names<Enum>;
template <>
inline constexpr std::array<std::string_view, enum_size<FifoKind>()> choice_names<FifoKind>{"auto", "shift_register",
                                                                                            "memory"};

template <class Enum> std::vector<std::string> names_of_choices() {
    return {choice_names<Enum>.begin(), choice_names<Enum>.end()};
}

template <class Enum> std::string choice_name(Enum value) {
    return std::string(choice_names<Enum>[static_cast<std::size_t>(value)]);
}

/// `name` must be one of names_of_choices(): the readers check before.
template <class Enum> Enum choice_from_name(std::string_view name) {
    auto const& names = choice_names<Enum>;
    return static_cast<Enum>(std::find(names.begin(), names.end(), name) - names.begin());
}

}  // namespace dataflow
