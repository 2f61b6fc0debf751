#include "tool/run_size.hpp"

#include <fmt/format.h>

#include "kernel/base/host_memory.hpp"
#include "kernel/base/input_error.hpp"

namespace faster {

namespace {

constexpr double longest_s = 3600;

/// Loop iterations per second of the host, measured with shipped configurations.
constexpr double rate_of_alike = 1e9;
constexpr double rate_of_other = 1e8;
constexpr double rate_in_lockstep = 1.5e6;

constexpr double bytes_of_core = 300e3;
constexpr double bytes_of_fifo_place = 32;  ///< of its times and its tokens
constexpr double bytes_of_sample = 400;     ///< of its figures

double bytes_of(Machine const& machine) {
    double bytes = bytes_of_core;
    for (MachineFifo const& fifo : machine.fifos)
        if (fifo.is_present)
            bytes += bytes_of_fifo_place * static_cast<double>(fifo.capacity());
    for (MachineMemory const& memory : machine.memories)
        if (memory.is_present)
            bytes += static_cast<double>(memory.words * memory.shape.buffers * ((memory.shape.bits + 7) / 8));
    return bytes * static_cast<double>(machine.cores);
}

std::string memory_text(double bytes) { return fmt::format("{:.1f} GiB", bytes / (1U << 30U)); }

std::string time_text(double seconds) {
    if (seconds < 120)
        return fmt::format("{:.0f} seconds", seconds);
    if (seconds < 7200)
        return fmt::format("{:.0f} minutes", seconds / 60);
    return seconds < 172'800 ? fmt::format("{:.0f} hours", seconds / 3600)
                             : fmt::format("{:.0f} days", seconds / 86'400);
}

constexpr char const* way_out = "a smaller run, or run --force";

}  // namespace

RunSize size_of_run(RunConfig const& config, Machine const& machine, Workload const& workload) {
    RunSize size;
    size.samples = workload.samples();
    size.iterations = workload.iterations();
    size.seconds = config.simulation.engine == Engine::lockstep
                       ? size.iterations.all() / rate_in_lockstep
                       : size.iterations.alike / rate_of_alike + size.iterations.other / rate_of_other;
    size.bytes = bytes_of(machine) + bytes_of_sample * static_cast<double>(size.samples);
    return size;
}

std::string text_of(RunSize const& size) {
    return fmt::format("{} samples, about {:.2g} loop iterations: about {}, {}", size.samples, size.iterations.all(),
                       time_text(size.seconds), memory_text(size.bytes));
}

void require_memory(RunSize const& size) {
    auto const available = static_cast<double>(available_memory_bytes());
    if (size.bytes > available)
        throw InputError(fmt::format("the run takes about {} of memory, of which {} are available, expected {}",
                                     memory_text(size.bytes), memory_text(available), way_out));
}

void require_time(RunSize const& size) {
    if (size.seconds > longest_s)
        throw InputError(fmt::format("the run is long ({}), expected {}", text_of(size), way_out));
}

}  // namespace faster
