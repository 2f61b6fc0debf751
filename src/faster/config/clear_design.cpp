#include "faster/config/clear_design.hpp"

#include <algorithm>

#include "dataflow/core/machine/bank_partition.hpp"
#include "faster/config/edge_map_design.hpp"
#include "faster/dataflow_names.hpp"

namespace faster {
namespace {

/// All banks side by side, so the largest decides.
std::size_t iterations(std::string const& memory, AcceleratorConfig const& config, int window) {
    auto const side = static_cast<std::size_t>(window);
    switch (clearing_of(memory, config)) {
        case MapClearing::loop:
            return side * side;
        case MapClearing::on_read_out:
            return 0;
        case MapClearing::wide:
            break;
    }
    return BankPartition(config.memory(memory).partition, window).bank_words();
}

}  // namespace

MapClearing clearing_of(std::string const& memory, AcceleratorConfig const& config) {
    return memory == "depth_buffer" ? config.inlier_unit.clearing : config.edge_map.clearing;
}

std::size_t edge_clear_iterations(AcceleratorConfig const& config, int window) {
    PerMap const& bits = design_of(config.edge_map.algorithm).bits;
    std::size_t const edge = bits.edge_map > 0 ? iterations("edge_map", config, window) : 0;
    std::size_t const object = bits.object_map > 0 ? iterations("object_map", config, window) : 0;
    return std::max(edge, object);
}

std::size_t depth_clear_iterations(AcceleratorConfig const& config, int window) {
    return iterations("depth_buffer", config, window);
}

}  // namespace faster
