#include "kernel/report/html/area_data.hpp"

#include "kernel/figures/table_rows.hpp"
#include "kernel/report/json_rows.hpp"

namespace faster::report {

Json area_data(RunStatistics const& run) {
    return {{"memories", json_table(memory_columns, over_cores(memory_columns, memory_rows(run)))},
            {"ramb36_of_device", ramb36_of_device}};
}

}  // namespace faster::report
