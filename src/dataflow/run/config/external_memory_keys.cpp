#include "dataflow/run/config/external_memory_keys.hpp"

#include <fmt/format.h>
#include <limits>

#include "dataflow/run/config/config_sources.hpp"
#include "dataflow/run/config/key_builders.hpp"

namespace dataflow {
namespace {

using Make = KeyMaker<MachineSettings>;

constexpr char const* this_project = "this project";

std::string key_name(char const* part) { return std::string("accelerator.memory.") + part; }

void add_request_keys(Keys& keys) {
    keys.push_back(of_time(Make::integer_key(
        {key_name("burst_bytes"), "bytes",
         "Longest burst; ranges are cut at its multiples. A power of two, at least port_bytes.",
         "AXI3: 16 beats of 16 bytes"},
        {4, 4096}, [](auto& settings) -> auto& { return settings.external_memory.burst_bytes; })));
    keys.push_back(of_time(Make::integer_key(
        {key_name("port_bytes"), "bytes", "Bytes of a beat, of which a port moves one per cycle. A power of two.",
         "ZCU102, HP ports"},
        {4, 4096}, [](auto& settings) -> auto& { return settings.external_memory.port_bytes; })));
    keys.push_back(step_of_time(Make::integer_key(
        {key_name("outstanding"), "bursts", "Bursts of a master that may be asked for and not done.", this_project},
        {1, 1'048'576}, [](auto& settings) -> auto& { return settings.external_memory.outstanding; })));
    keys.push_back(of_time(Make::boolean_key(
        {key_name("prefetch"), "", "Whether masters work ahead of their processes, across samples.", this_project},
        [](auto& settings) -> auto& { return settings.external_memory.prefetch; })));
    keys.push_back(step_of_time(Make::integer_key(
        {key_name("ports"), "", "Ports between cores and memory; core c uses port c mod ports.", "ZCU102, FPT 2019"},
        {1, 1024}, [](auto& settings) -> auto& { return settings.external_memory.ports; })));
    keys.push_back(step_of_time(Make::integer_key(
        {key_name("request_cycles"), "cycles", "From asking for a burst to its arrival at the controller.",
         this_project},
        {0, 1'000'000}, [](auto& settings) -> auto& { return settings.external_memory.request_cycles; })));
}

void add_dram_keys(Keys& keys) {
    keys.push_back(of_time(Make::number_key(
        {key_name("dram_gb_per_s"), "GB/s", "Peak bandwidth of the memory, in 1e9 bytes per second.",
         "ZCU102, DDR4-2400"},
        {1e-3, 1e6}, [](auto& settings) -> auto& { return settings.external_memory.dram_gb_per_s; })));
    keys.push_back(of_time(Make::number_key(
        {key_name("dram_efficiency"), "", "Part of the peak that can be had; row misses and refresh are in it.",
         "FPT 2019"},
        {1e-3, 1}, [](auto& settings) -> auto& { return settings.external_memory.dram_efficiency; })));
    keys.push_back(of_time(Make::number_key(
        {key_name("read_latency_ns"), "ns",
         "From the begin of a burst at the controller to its first beat at the port.", this_project},
        {0, 1e6}, [](auto& settings) -> auto& { return settings.external_memory.read_latency_ns; })));
}

void check_power_of_two(LoadedConfig const& loaded, std::string const& key, std::uint64_t value,
                        std::vector<std::string>& complaints) {
    if ((value & (value - 1)) != 0)
        complaints.push_back(complaint(loaded, key, "a power of two"));
}

}  // namespace

Keys external_memory_keys() {
    Keys keys;
    keys.push_back(of_time(Make::choice_key(
        {key_name("model"), "",
         "Whether data from outside the cores cost time: ideal, none; axi, bursts over ports and a controller that all "
         "cores share.",
         this_project},
        [](auto& settings) -> auto& { return settings.external_memory.model; })));
    add_request_keys(keys);
    add_dram_keys(keys);
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
