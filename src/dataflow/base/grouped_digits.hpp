#pragma once
#include <cstdint>
#include <optional>
#include <string>

namespace dataflow {

/// Of a whole number without a sign.
inline std::string grouped_digits(std::string digits) {
    for (std::size_t left = digits.size(); left > 3;) {
        left -= 3;
        digits.insert(left, 1, ',');
    }
    return digits;
}

/// For people, e.g. "2,479,934", or "-" for none. Files have plain digits.
inline std::string grouped(std::uint64_t number) { return grouped_digits(std::to_string(number)); }
inline std::string grouped(std::optional<std::uint64_t> number) { return number ? grouped(*number) : "-"; }

/// With its sign, e.g. "-2,479,934"; none is "+0".
inline std::string grouped_change(std::int64_t change) {
    auto const size = static_cast<std::uint64_t>(change);
    return change < 0 ? "-" + grouped(0 - size) : "+" + grouped(size);
}

}  // namespace dataflow
