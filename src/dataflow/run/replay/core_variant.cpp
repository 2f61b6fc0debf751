#include "dataflow/run/replay/core_variant.hpp"

#include "dataflow/core/machine/build_core.hpp"

namespace dataflow::replay {

namespace {

/// Numbers in the machine.
std::vector<std::size_t> streams_of(timing::CoreTiming const& blueprint, Machine const& machine) {
    std::vector<std::size_t> streams;
    for (timing::MemoryStream const& stream : blueprint.streams())
        streams.push_back(machine.stream(stream.name()));
    return streams;
}

/// What deadlock reports name.
void copy_sites(timing::ProcessTiming const& process, timing::ProcessTiming& variant) {
    for (unsigned loop = 0; loop < process.loops().size(); ++loop)
        variant.note_loop_site(loop, process.loop_site(loop));
    for (unsigned port = 0; port < process.port_count(); ++port)
        variant.note_site(port, process.port_site(port));
}

/// As a run there would, whose module would be kept from earlier accesses.
void require_first_reads(timing::ProcessTiming const& process, timing::ProcessTiming const& variant) {
    try {
        for (unsigned loop = 0; loop < process.loops().size(); ++loop)
            for (unsigned port = 0; port < process.port_count(); ++port)
                if (process.first_reads(loop).has(port))
                    variant.require_first(loop, port);
    } catch (InputError const& error) {
        throw NotRetimable(error.what());
    }
}

}  // namespace

std::unique_ptr<timing::PhraseCore> core_variant(timing::CoreTiming const& blueprint, Machine const& machine) {
    std::unique_ptr<timing::PhraseCore> core = timing::make_core();
    build_core(*core, machine, streams_of(blueprint, machine));
    for (timing::ProcessTiming const& process : blueprint.processes()) {
        timing::ProcessTiming& variant = core->process(process.index());
        require_first_reads(process, variant);
        copy_sites(process, variant);
    }
    return core;
}

}  // namespace dataflow::replay
