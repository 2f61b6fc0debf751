#include "dataflow/tools/report/diagnosis_text.hpp"

#include <fmt/format.h>

namespace dataflow::report {

namespace {

std::string share(Cycles part, Diagnosis const& diagnosis) {
    return fmt::format("{:.1f} %", 100.0 * static_cast<double>(part) / static_cast<double>(diagnosis.cycles));
}

/// "line_buffer has 5 accesses per iteration on 2 ports"
std::string crowding(LoopStatistics const& loop, Machine const& machine) {
    MachineMemory const& memory = machine.memories[machine.memory(loop.bram)];
    return fmt::format("{}{} has {} accesses per iteration on {} port{}",
                       memory.partition.banks() > 1 ? "a bank of " : "", loop.bram, loop.bram_accesses, memory.ports,
                       memory.ports == 1 ? "" : "s");
}

std::string why(LoopStatistics const& loop, Machine const& machine) {
    if (loop.limited_by.empty())
        return fmt::format("at II {}", loop.ii);
    if (loop.limited_by == "recurrence")
        return fmt::format("at II {}, because a recurrence demands it", loop.ii);
    return fmt::format("at II {}, because {}", loop.ii, crowding(loop, machine));
}

std::string loop_sentence(Cause const& cause, Diagnosis const& diagnosis, RunStatistics const& run) {
    std::string sentence = fmt::format("{} is {} {}", share(cause.cycles, diagnosis), run.machine.loop_name(cause.item),
                                       why(run.cores.front().loops[cause.item], run.machine));
    if (cause.port_conflict > 0)
        sentence += fmt::format(": {} are port conflicts", share(cause.port_conflict, diagnosis));
    if (cause.interlock > 0)
        sentence += fmt::format("{} {} of iterations that wait for writes", cause.port_conflict > 0 ? "," : ":",
                                share(cause.interlock, diagnosis));
    return sentence + ".";
}

std::string stall_sentence(Cause const& cause, Diagnosis const& diagnosis, Machine const& machine) {
    MachineFifo const& fifo = machine.fifos[cause.item];
    bool const reads = fifo.reader == diagnosis.module;
    return fmt::format("{} {} waits for {}: {} is {}.", share(cause.cycles, diagnosis),
                       machine.processes[diagnosis.module].name,
                       machine.processes[reads ? fifo.writer : fifo.reader].name, fifo.name, reads ? "empty" : "full");
}

std::string sentence_of(Cause const& cause, Diagnosis const& diagnosis, RunStatistics const& run) {
    MachineProcess const& process = run.machine.processes[diagnosis.module];
    std::string const& module = process.name;
    switch (cause.kind) {
        case Cause::Kind::loop:
            return loop_sentence(cause, diagnosis, run);
        case Cause::Kind::stall:
            return stall_sentence(cause, diagnosis, run.machine);
        case Cause::Kind::memory_stall:
            return fmt::format("{} {} waits for memory.", share(cause.cycles, diagnosis), module);
        case Cause::Kind::setup:
            if (process.setup_activity.empty())
                return fmt::format("{} {} waits for the cycle in which it may start.", share(cause.cycles, diagnosis),
                                   module);
            return fmt::format("{} is {} {}, {} cycles each.", share(cause.cycles, diagnosis), module,
                               process.setup_activity, process.setup_cycles);
        case Cause::Kind::fill_drain:
            return fmt::format("{} is {} filling and draining pipelines.", share(cause.cycles, diagnosis), module);
        case Cause::Kind::idle:
            return fmt::format("{} {} has nothing to do, yet or any more.", share(cause.cycles, diagnosis), module);
        case Cause::Kind::between_loops:
            break;
    }
    return fmt::format("{} is {} between its loops.", share(cause.cycles, diagnosis), module);
}

}  // namespace

std::vector<std::string> diagnosis_sentences(RunStatistics const& run) {
    Diagnosis const diagnosis = diagnose(run);
    std::vector<std::string> sentences;
    if (diagnosis.cycles == 0)
        return sentences;
    sentences.push_back(fmt::format("Bound by {}, which waits least: {} of the time of core {}, the last to end.",
                                    run.machine.processes[diagnosis.module].name, share(diagnosis.waits, diagnosis),
                                    diagnosis.core));
    for (Cause const& cause : diagnosis.causes)
        if (cause.cycles * 100 >= diagnosis.cycles)
            sentences.push_back(sentence_of(cause, diagnosis, run));
    return sentences;
}

}  // namespace dataflow::report
