#include "dataflow/run/replay/core_variant.hpp"

namespace dataflow::replay {

namespace {

timing::LoopShape variant_of(timing::LoopShape const& loop, timing::ProcessTiming const& variant,
                             Machine const& machine) {
    timing::LoopShape shape = machine.loops[machine.loop(variant.index(), loop.name)].shape();
    for (timing::LoopWrite const& write : loop.writes)
        shape.writes.push_back({write.port, variant.fifo(write.port).is_memory()
                                                ? shape.depth - 1
                                                : variant.fifo(write.port).shape().write_latency});
    shape.uses_memory = loop.uses_memory;
    for (timing::LoopRead const& read : loop.reads)
        shape.reads.push_back({read.port, variant.fifo(read.port).shape().read_stage});
    return shape;
}

/// What deadlock reports name.
void copy_sites(timing::ProcessTiming const& process, timing::ProcessTiming& variant) {
    for (unsigned loop = 0; loop < process.loops().size(); ++loop)
        variant.note_loop_site(loop, process.loop_site(loop));
    for (unsigned port = 0; port < process.port_count(); ++port)
        variant.note_site(port, process.port_site(port));
}

}  // namespace

std::unique_ptr<timing::PhraseCore> core_variant(timing::CoreTiming const& blueprint, Machine const& machine) {
    std::unique_ptr<timing::PhraseCore> core = timing::make_core();
    for (MachineFifo const& fifo : machine.fifos)
        core->add_fifo(fifo.shape());
    for (timing::MemoryStream const& stream : blueprint.streams())
        core->add_stream(stream.name(), stream.enters_by());
    for (timing::ProcessTiming const& process : blueprint.processes()) {
        timing::ProcessTiming& variant = core->add_process(process.name());
        for (unsigned port = 0; port < process.port_count(); ++port) {
            if (process.fifo(port).is_memory()) {
                variant.add_stream(core->stream(blueprint.number_of(*process.stream())));
                continue;
            }
            timing::FifoTiming& fifo = core->fifo(blueprint.number_of(process.fifo(port)));
            process.writes(port) ? variant.add_writes(fifo) : variant.add_reads(fifo);
        }
        for (timing::LoopShape const& loop : process.loops())
            variant.add_loop(variant_of(loop, variant, machine));
        copy_sites(process, variant);
        variant.set_setup_cycles(machine.processes[variant.index()].setup_cycles);
        variant.set_call_start(machine.processes[variant.index()].call_start);
        variant.let_stamps_look_back(machine.processes[variant.index()].stamps_look_back);
    }
    return core;
}

}  // namespace dataflow::replay
