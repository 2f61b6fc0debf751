#include "dataflow/tools/recording/signal_filter.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fnmatch.h>

#include "dataflow/base/input_error.hpp"
#include "dataflow/base/nearest_name.hpp"

namespace dataflow::recording {

namespace {

constexpr char const* name_of_external_memory = "memory";

std::vector<std::string> all_names(Machine const& machine) {
    std::vector<std::string> names;
    for (std::size_t const process : modules_of(machine))
        names.push_back(machine.processes[process].name);
    for (std::size_t const fifo : fifos_of(machine))
        names.push_back(machine.fifos[fifo].name);
    for (std::size_t const memory : brams_of(machine))
        names.push_back(machine.memories[memory].name);
    if (machine.external_memory)
        names.emplace_back(name_of_external_memory);
    return names;
}

bool fits(std::string const& pattern, std::string const& name) {
    return fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
}

void require_matches(std::vector<std::string> const& patterns, Machine const& machine) {
    std::vector<std::string> const names = all_names(machine);
    for (std::string const& pattern : patterns) {
        auto const hit = [&pattern](std::string const& name) { return fits(pattern, name); };
        if (std::none_of(names.begin(), names.end(), hit))
            throw InputError(
                fmt::format("--vcd-modules {}: matches no module, FIFO or block RAM, expected a name or a "
                            "pattern such as '*_in'{}",
                            pattern, did_you_mean(pattern, names)));
    }
}

}  // namespace

SignalFilter::SignalFilter(std::vector<std::string> const& patterns, Machine const& machine) {
    require_matches(patterns, machine);
    auto const matches = [&patterns](std::string const& name) {
        return patterns.empty() || std::any_of(patterns.begin(), patterns.end(),
                                               [&name](std::string const& pattern) { return fits(pattern, name); });
    };
    for (MachineProcess const& process : machine.processes)
        processes_.push_back(process.is_present && matches(process.name));
    for (MachineFifo const& fifo : machine.fifos)
        fifos_.push_back(fifo.is_present && (matches(fifo.name) || processes_[fifo.writer] || processes_[fifo.reader]));
    for (MachineMemory const& memory : machine.memories)
        memories_.push_back(memory.is_present &&
                            (matches(memory.name) || processes_[memory.owner] || processes_[memory.reader]));
    external_memory_ = machine.external_memory && matches(name_of_external_memory);
}

SignalFilter SignalFilter::fifos(Machine const& machine) {
    SignalFilter filter;
    filter.processes_.resize(machine.processes.size());
    filter.memories_.resize(machine.memories.size());
    for (MachineFifo const& fifo : machine.fifos)
        filter.fifos_.push_back(fifo.is_present);
    filter.samples_ = false;
    return filter;
}

}  // namespace dataflow::recording
