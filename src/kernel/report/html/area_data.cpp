#include "kernel/report/html/area_data.hpp"

#include "kernel/figures/table_rows.hpp"
#include "kernel/report/json_rows.hpp"

namespace faster::report {

Json area_data(RunStatistics const& run, std::vector<FifoCost> const& fifo_costs) {
    Json fifos = Json::array();
    for (FifoCost const& cost : fifo_costs)
        fifos.push_back({{"fifo", cost.fifo}, {"bits", cost.bits}, {"luts", cost.luts}, {"ramb36", cost.ramb36}});
    return {{"memories", json_table(memory_columns, over_cores(memory_columns, memory_rows(run)))},
            {"fifo_costs", fifos},
            {"ramb36_of_device", ramb36_of_device}};
}

}  // namespace faster::report
