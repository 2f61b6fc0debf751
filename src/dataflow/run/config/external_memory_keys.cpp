#include "dataflow/run/config/external_memory_keys.hpp"

#include <fmt/format.h>
#include <limits>

#include "dataflow/run/config/config_sources.hpp"
#include "dataflow/run/config/key_builders.hpp"

namespace dataflow {
namespace {

constexpr char const* this_project = "this project";

std::string key_name(char const* part) { return std::string("accelerator.memory.") + part; }

void check_power_of_two(LoadedConfig const& loaded, std::string const& key, std::uint64_t value,
                        std::vector<std::string>& complaints) {
    if ((value & (value - 1)) != 0)
        complaints.push_back(complaint(loaded, key, "a power of two"));
}

}  // namespace

Keys external_memory_keys() {
    using Memory = ExternalMemorySettings;
    Keys keys;
    auto memory = key_section(keys, "accelerator.memory", &MachineSettings::external_memory);
    memory.choice("model", "",
                  "Whether data from outside the cores cost time: ideal, none; axi, bursts over ports and a controller "
                  "that all cores share.",
                  this_project, &Memory::model);
    memory.integer("burst_bytes", "bytes",
                   "Longest burst; ranges are cut at its multiples. A power of two, at least port_bytes.",
                   "AXI3: 16 beats of 16 bytes", {4, 4096}, &Memory::burst_bytes);
    memory.integer("port_bytes", "bytes", "Bytes of a beat, of which a port moves one per cycle. A power of two.",
                   "ZCU102, HP ports", {4, 4096}, &Memory::port_bytes);
    memory
        .integer("outstanding", "bursts", "Bursts of a master that may be asked for and not done.", this_project,
                 {1, 1'048'576}, &Memory::outstanding)
        .is_step = true;
    memory.boolean("prefetch", "", "Whether masters work ahead of their processes, across samples.", this_project,
                   &Memory::prefetch);
    memory
        .integer("ports", "", "Ports between cores and memory; core c uses port c mod ports.", "ZCU102, FPT 2019",
                 {1, 1024}, &Memory::ports)
        .is_step = true;
    memory
        .integer("request_cycles", "cycles", "From asking for a burst to its arrival at the controller.", this_project,
                 {0, 1'000'000}, &Memory::request_cycles)
        .is_step = true;
    memory.number("dram_gb_per_s", "GB/s", "Peak bandwidth of the memory, in 1e9 bytes per second.",
                  "ZCU102, DDR4-2400", {1e-3, 1e6}, &Memory::dram_gb_per_s);
    memory.number("dram_efficiency", "", "Part of the peak that can be had; row misses and refresh are in it.",
                  "FPT 2019", {1e-3, 1}, &Memory::dram_efficiency);
    memory.number("read_latency_ns", "ns", "From the begin of a burst at the controller to its first beat at the port.",
                  this_project, {0, 1e6}, &Memory::read_latency_ns);
    for (Key& key : keys)
        key.decides_time = true;
    return keys;
}

std::vector<std::string> external_memory_complaints(LoadedConfig const& loaded) {
    ExternalMemorySettings const& memory = loaded.config.machine().external_memory;
    std::vector<std::string> complaints;
    check_power_of_two(loaded, key_name("port_bytes"), memory.port_bytes, complaints);
    check_power_of_two(loaded, key_name("burst_bytes"), memory.burst_bytes, complaints);
    if (memory.burst_bytes < memory.port_bytes)
        complaints.push_back(complaint(loaded, key_name("burst_bytes"),
                                       fmt::format("at least {}", with_value(loaded, key_name("port_bytes")))));
    return complaints;
}

}  // namespace dataflow
