#pragma once
#include <cstdint>
#include <string>

namespace dataflow {

/// For people, e.g. "2,479,934". Files have plain digits.
inline std::string grouped(std::uint64_t number) {
    std::string text = std::to_string(number);
    for (std::size_t left = text.size(); left > 3;) {
        left -= 3;
        text.insert(left, 1, ',');
    }
    return text;
}

/// With its sign, e.g. "-2,479,934"; none is "+0".
inline std::string grouped_change(std::int64_t change) {
    auto const size = static_cast<std::uint64_t>(change);
    return change < 0 ? "-" + grouped(0 - size) : "+" + grouped(size);
}

}  // namespace dataflow
