#pragma once
#include <cstdint>
#include <limits>
#include <vector>

#include "kernel/base/files/csv_integers.hpp"

namespace faster::io {

/// The columns of the two tables of a trace, in the order in which they are written, with the limits of the formats.
inline std::vector<CsvColumn> sample_columns() {
    std::int64_t const index_max = std::numeric_limits<std::uint32_t>::max();
    std::int64_t const pixel_min = std::numeric_limits<std::int32_t>::min();
    std::int64_t const pixel_max = std::numeric_limits<std::int32_t>::max();
    return {{"sample", 0, index_max},
            {"centre_row", pixel_min, pixel_max},
            {"centre_col", pixel_min, pixel_max},
            {"first_triangle", 0, index_max},
            {"triangle_count", 0, index_max}};
}

inline std::vector<CsvColumn> triangle_columns() {
    std::vector<CsvColumn> columns;
    for (char const* vertex : {"0", "1", "2"}) {
        columns.push_back({std::string("x") + vertex, -32768, 32767});
        columns.push_back({std::string("y") + vertex, -32768, 32767});
        columns.push_back({std::string("z") + vertex, 0, 65535});
    }
    return columns;
}

}  // namespace faster::io
