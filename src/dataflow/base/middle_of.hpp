#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

namespace dataflow {

/// The median; of an even number the larger one in the middle. Of at least one value.
inline double middle_of(std::vector<double> values) {
    auto const middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace dataflow
