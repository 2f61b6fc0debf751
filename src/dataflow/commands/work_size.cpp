#include "dataflow/commands/work_size.hpp"

#include <fmt/format.h>

#include "dataflow/base/host_clock.hpp"
#include "dataflow/base/host_memory.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/base/on_threads.hpp"
#include "dataflow/commands/say.hpp"
#include "dataflow/run/replay/retime.hpp"

namespace dataflow {

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
        if (memory.is_present) {
            std::uint64_t const bytes_of_word = (memory.shape.bits + 7) / 8;
            bytes += static_cast<double>(memory.words * memory.shape.buffers * bytes_of_word);
        }
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

/// "620 samples, about 2.1e+10 loop iterations: about 12 minutes, 1.2 GiB"
std::string text_of(WorkSize const& size) {
    return fmt::format("{}: about {}, {}", size.amount, time_text(size.seconds), memory_text(size.bytes));
}

}  // namespace

WorkSize size_of_run(RunConfig const& config, Machine const& machine, std::size_t samples,
                     LoopIterations const& iterations) {
    WorkSize size;
    size.command = "run";
    size.amount = fmt::format("{} samples", samples);
    if (iterations.all() > 0)
        size.amount += fmt::format(", about {:.2g} loop iterations", iterations.all());
    size.seconds = config.simulation.engine == Engine::lockstep
                       ? iterations.all() / rate_in_lockstep
                       : iterations.alike / rate_of_alike + iterations.other / rate_of_other;
    size.bytes = bytes_of(machine) + bytes_of_sample * static_cast<double>(samples);
    return size;
}

WorkSize size_of_run(RunConfig const& config, Machine const& machine, Workload const& workload) {
    return size_of_run(config, machine, workload.samples(), workload.iterations());
}

WorkSize size_of_retimings(std::string const& command, replay::RecordedRun const& run, Machine const& machine,
                           double retimings) {
    WorkSize size;
    size.command = command;
    size.amount = fmt::format("about {:.0f} retimings of {} samples", retimings, run.tape.samples());
    size.bytes = bytes_of(machine) + bytes_of_sample * static_cast<double>(run.tape.samples());
    return size;
}

void require_memory(WorkSize const& size) {
    auto const available = static_cast<double>(available_memory_bytes());
    if (size.bytes > available)
        throw InputError(
            fmt::format("{}: would take about {} of memory, of which {} are available, expected less, or {} --force",
                        size.command, memory_text(size.bytes), memory_text(available), size.command));
}

void require_time(WorkSize const& size) {
    if (size.seconds > longest_s)
        throw InputError(fmt::format("{}: would take long ({}), expected less than an hour of work, or {} --force",
                                     size.command, text_of(size), size.command));
}

void announce(WorkSize const& size, bool force) {
    if (!force) {
        require_memory(size);
        require_time(size);
    }
    if (size.seconds < announced_s)
        return;
    say("{}\n", text_of(size));
    finish_saying();
}

void announce_retimings(std::string const& command, replay::RecordedRun const& run, Machine const& machine,
                        double retimings, bool force) {
    WorkSize size = size_of_retimings(command, run, machine, retimings);
    if (!force)
        require_memory(size);
    auto const start = HostClock::now();
    replay::retime(run, machine);
    double const seconds = seconds_since(start);
    size.seconds = seconds * retimings / static_cast<double>(jobs_or_host_cores(0));
    announce(size, force);
}

}  // namespace dataflow
