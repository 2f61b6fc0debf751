#include "kernel/report/diagnosis_text.hpp"

#include <fmt/format.h>

#include "faster/rasterizer_design.hpp"
#include "kernel/machine/bank_partition.hpp"

namespace faster::report {

namespace {

std::string share(Cycles part, Diagnosis const& diagnosis) {
    return fmt::format("{:.1f} %", 100.0 * static_cast<double>(part) / static_cast<double>(diagnosis.cycles));
}

BramConfig const& bram_named(std::string const& name, AcceleratorConfig const& config) {
    std::size_t i = 0;
    while (name != bram_names[i])
        ++i;
    return config.brams[i];
}

/// "depth_buffer has 5 accesses per iteration on 2 ports"
std::string crowding(LoopStatistics const& loop, AcceleratorConfig const& config) {
    BramConfig const& bram = bram_named(loop.bram, config);
    bool const is_split = BankPartition(bram.partition, config.window).banks() > 1;
    return fmt::format("{}{} has {} accesses per iteration on {} port{}", is_split ? "a bank of " : "", loop.bram,
                       loop.bram_accesses, bram.ports, bram.ports == 1 ? "" : "s");
}

std::string why(LoopStatistics const& loop, AcceleratorConfig const& config) {
    if (loop.limited_by.empty())
        return fmt::format("at II {}", loop.ii);
    if (loop.limited_by == "recurrence")
        return fmt::format("at II {}, because a recurrence demands it", loop.ii);
    return fmt::format("at II {}, because {}", loop.ii, crowding(loop, config));
}

std::string loop_sentence(Cause const& cause, Diagnosis const& diagnosis, AcceleratorConfig const& config,
                          RunStatistics const& run) {
    LoopName const& name = loop_names[cause.item];
    std::string sentence = fmt::format("{} is {}.{} {}", share(cause.cycles, diagnosis), name_of(name.module),
                                       name.name, why(run.cores.front().loops[cause.item], config));
    if (cause.port_conflict > 0)
        sentence += fmt::format(": {} are port conflicts", share(cause.port_conflict, diagnosis));
    return sentence + ".";
}

std::string stall_sentence(Cause const& cause, Diagnosis const& diagnosis, Parts const& parts) {
    FifoEnds const ends = ends_of(parts, FifoId{cause.item});
    bool const reads = index_of(ends.reader) == diagnosis.module;
    return fmt::format("{} {} waits for {}: {} is {}.", share(cause.cycles, diagnosis), module_names[diagnosis.module],
                       name_of(reads ? ends.writer : ends.reader), fifo_names[cause.item], reads ? "empty" : "full");
}

std::string sentence_of(Cause const& cause, Diagnosis const& diagnosis, AcceleratorConfig const& config,
                        RunStatistics const& run) {
    char const* const module = module_names[diagnosis.module];
    switch (cause.kind) {
        case Cause::Kind::loop:
            return loop_sentence(cause, diagnosis, config, run);
        case Cause::Kind::stall:
            return stall_sentence(cause, diagnosis, run.parts);
        case Cause::Kind::setup:
            return fmt::format(
                "{} is {} {}, {} cycles each.", share(cause.cycles, diagnosis), module,
                config.rasterizer.setup_overlap > 0 ? "waiting for triangles to be set up" : "setting up triangles",
                setup_cycles(config));
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

std::vector<std::string> diagnosis_sentences(AcceleratorConfig const& config, RunStatistics const& run) {
    Diagnosis const diagnosis = diagnose(run);
    std::vector<std::string> sentences;
    if (diagnosis.cycles == 0)
        return sentences;
    sentences.push_back(fmt::format("Bound by {}, which waits least: {} of the time of core {}, the last to end.",
                                    module_names[diagnosis.module], share(diagnosis.waits, diagnosis), diagnosis.core));
    for (Cause const& cause : diagnosis.causes)
        if (cause.cycles * 100 >= diagnosis.cycles)
            sentences.push_back(sentence_of(cause, diagnosis, config, run));
    return sentences;
}

}  // namespace faster::report
