#pragma once
#include <string_view>

#include "dataflow/tools/resources/path_table.hpp"
#include "dataflow/tools/resources/resource_table.hpp"
#include "faster/dataflow_names.hpp"

namespace faster {

/// rtl/resources.csv and rtl/timing.csv, byte by byte; scripts/synthesize.sh makes them.
extern std::string_view const synthesized_units_csv;
extern std::string_view const synthesized_paths_csv;
/// rtl/resources.csv as a table.
inline ResourceTable const& synthesized_units() {
    static ResourceTable const table(synthesized_units_csv);
    return table;
}

inline PathTable const& synthesized_paths() {
    static PathTable const table(synthesized_paths_csv);
    return table;
}

}  // namespace faster
