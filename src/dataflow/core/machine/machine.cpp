#include "dataflow/core/machine/machine.hpp"

#include <algorithm>
#include <string>

#include "dataflow/base/input_error.hpp"
#include "dataflow/base/nearest_name.hpp"

namespace dataflow {

namespace {

template <class Parts> std::size_t number_of(std::string_view name, Parts const& parts) {
    auto const found = std::find_if(parts.begin(), parts.end(), [name](auto const& part) { return part.name == name; });
    if (found == parts.end()) {
        std::vector<std::string> names;
        names.reserve(parts.size());
        for (auto const& part : parts)
            names.push_back(part.name);
        throw InputError(
            "the design describes no part " + std::string(name) +
            ", expected the name of a module, FIFO, loop or memory that it has (SystemC adds _0 to one that "
            "is there twice)" +
            did_you_mean(name, names));
    }
    return static_cast<std::size_t>(found - parts.begin());
}

template <class Parts> std::vector<std::size_t> present(Parts const& parts) {
    std::vector<std::size_t> numbers;
    for (std::size_t i = 0; i < parts.size(); ++i)
        if (parts[i].is_present)
            numbers.push_back(i);
    return numbers;
}

}  // namespace

timing::FifoShape MachineFifo::shape() const {
    timing::FifoShape shape;
    shape.name = name;
    shape.capacity = capacity();
    shape.read_latency = read_latency_of(kind);
    shape.write_latency = write_latency;
    shape.read_stage = read_stage;
    if (hands_over > 0)
        shape.read_latency = shape.room_latency = 0;
    if (flushes)
        (when_full == WhenFull::freeze ? shape.flushing_stages : shape.issue_latency) = write_latency;
    return shape;
}

timing::MemoryStream::EntersBy MachineStream::enters_by() const {
    using EntersBy = timing::MemoryStream::EntersBy;
    return writes ? EntersBy::write : loop.empty() ? EntersBy::step : EntersBy::loop;
}

timing::LoopShape MachineLoop::shape() const {
    timing::LoopShape shape;
    shape.name = name;
    shape.interval = interval;
    shape.depth = depth;
    shape.entry_states = entry_states;
    shape.exit_states = exit_states;
    shape.makes_attempts = makes_attempts;
    shape.rewinds = rewinds;
    if (has_interlocks())
        for (MachineDependence const& dependence : dependences)
            shape.interlock_spans.push_back(dependence.interlocks() ? dependence.span() : 1);
    return shape;
}

std::optional<std::size_t> MachineLoop::dependence_on(std::size_t memory) const {
    auto const found =
        std::find_if(dependences.begin(), dependences.end(),
                     [memory](MachineDependence const& dependence) { return dependence.memory == memory; });
    if (found == dependences.end())
        return std::nullopt;
    return static_cast<std::size_t>(found - dependences.begin());
}

bool MachineLoop::has_interlocks() const {
    return std::any_of(dependences.begin(), dependences.end(),
                       [](MachineDependence const& dependence) { return dependence.interlocks(); });
}

std::size_t Machine::process_places() const { return modules_of(*this).back() + 1; }
std::size_t Machine::process(std::string_view name) const { return number_of(name, processes); }
std::size_t Machine::fifo(std::string_view name) const { return number_of(name, fifos); }
std::size_t Machine::memory(std::string_view name) const { return number_of(name, memories); }

std::size_t Machine::stream(std::string_view name) const { return number_of(name, streams); }

std::size_t Machine::loop(std::size_t process, std::string_view name) const {
    auto const found = std::find_if(loops.begin(), loops.end(), [=](MachineLoop const& loop) {
        return loop.process == process && loop.name == name;
    });
    if (found == loops.end())
        throw InputError("module " + processes[process].name + " has no loop " + std::string(name) +
                         ", expected loop(\"" + std::string(name) + "\") in its describe()");
    return static_cast<std::size_t>(found - loops.begin());
}

char const* against_rewinding(Machine const& machine, MachineLoop const& loop) {
    bool const is_late = std::any_of(loop.reads.begin(), loop.reads.end(),
                                     [&](std::size_t fifo) { return machine.fifos[fifo].read_stage > 0; });
    return is_late               ? "reads a FIFO in a later stage than its first"
           : loop.makes_attempts ? "accesses a FIFO without waiting"
                                 : nullptr;
}

std::vector<std::size_t> modules_of(Machine const& machine) { return present(machine.processes); }
std::vector<std::size_t> fifos_of(Machine const& machine) { return present(machine.fifos); }
std::vector<std::size_t> loops_of(Machine const& machine) { return present(machine.loops); }
std::vector<std::size_t> brams_of(Machine const& machine) { return present(machine.memories); }

bool has_interlocks(Machine const& machine) {
    return std::any_of(machine.loops.begin(), machine.loops.end(),
                       [](MachineLoop const& loop) { return loop.is_present && loop.has_interlocks(); });
}

bool makes_attempts(Machine const& machine) {
    return std::any_of(machine.processes.begin(), machine.processes.end(), [](MachineProcess const& process) {
        return process.is_present && std::any_of(process.ends.begin(), process.ends.end(),
                                                 [](MachineEnd const& end) { return end.makes_attempts; });
    });
}

std::vector<std::size_t> streams_of(Machine const& machine) { return present(machine.streams); }

std::vector<timing::MemorySystem::MasterShape> masters_of(Machine const& machine) {
    std::vector<timing::MemorySystem::MasterShape> masters;
    for (std::size_t const i : streams_of(machine)) {
        MachineStream const& stream = machine.streams[i];
        masters.push_back({static_cast<unsigned>(stream.process), stream.prefetch, stream.is_header});
    }
    return masters;
}

double ramb36_of_core(Machine const& machine) {
    double sum = 0;
    for (MachineMemory const& memory : machine.memories)
        sum += ramb36_count(memory.shape);
    for (LineBuffer const& buffer : machine.line_buffers)
        sum += ramb36_count({buffer.words, buffer.bits});
    return sum;
}

}  // namespace dataflow
