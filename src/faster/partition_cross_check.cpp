#include <fmt/format.h>

#include "kernel/config/config_sources.hpp"
#include "kernel/config/key_names.hpp"
#include "kernel/machine/bank_partition.hpp"

namespace faster {
namespace {

constexpr std::uint64_t most_banks = 1024;  ///< more than any device has block RAMs

std::string type_needed(LoadedConfig const& loaded, BramId bram, char const* without) {
    return fmt::format("{}, or {} to be cyclic or block", without,
                       with_value(loaded, bram_key_name(bram, "partition.type")));
}

}  // namespace

void check_partition(LoadedConfig const& loaded, BramId bram, std::vector<std::string>& complaints) {
    PartitionConfig const& partition = loaded.config.accelerator.bram(bram).partition;
    std::string const factor_key = bram_key_name(bram, "partition.factor");
    std::string const dimension_key = bram_key_name(bram, "partition.dimension");
    int const window = loaded.config.accelerator.window;
    bool const is_split = partition.type != PartitionType::none;
    if (!is_split && partition.factor != 1) {
        complaints.push_back(complaint(loaded, factor_key, type_needed(loaded, bram, "1")));
    } else if (!is_split && partition.dimension != 0) {
        complaints.push_back(complaint(loaded, dimension_key, type_needed(loaded, bram, "0")));
    } else if (!is_split) {
        return;
    } else if (partition.factor > static_cast<std::uint64_t>(window)) {
        complaints.push_back(
            complaint(loaded, factor_key, fmt::format("at most {}", with_value(loaded, "accelerator.window"))));
    } else if (BankPartition(partition, window).banks() > most_banks) {
        complaints.push_back(
            complaint(loaded, factor_key,
                      fmt::format("at most {} banks in all, with {}", most_banks, with_value(loaded, dimension_key))));
    }
}

}  // namespace faster
