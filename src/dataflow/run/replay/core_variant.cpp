#include "dataflow/run/replay/core_variant.hpp"

#include <fmt/format.h>

#include "dataflow/base/program_name.hpp"
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

/// `call(loop, port)` for all ports that are noted of loops.
template <class Call>
void each_noted(timing::ProcessTiming const& process, timing::Ports timing::LoopNotes::*ports, Call const& call) {
    for (unsigned loop = 0; loop < process.loops().size(); ++loop)
        for (unsigned port = 0; port < process.port_count(); ++port)
            if ((process.notes(loop).*ports).has(port))
                call(loop, port);
}

/// As a run there would, whose module would be kept from earlier accesses.
void require_first_reads(timing::ProcessTiming const& process, timing::ProcessTiming const& variant) {
    try {
        each_noted(process, &timing::LoopNotes::first,
                   [&](unsigned loop, unsigned port) { variant.require_first(loop, port); });
    } catch (InputError const& error) {
        throw NotRetimable(error.what());
    }
}

/// How many iterations of a loop begin before the module has what one of them accesses later, itself included.
std::uint64_t begun_before(timing::ProcessTiming const& process, unsigned loop, unsigned port) {
    timing::LoopShape const& shape = process.loops()[loop];
    Cycles const stage = shape.makes_attempts ? process.shape()->plans[loop].step_of(port).value_or(0)
                                              : process.fifo(port).shape().read_stage;
    return stage == 0 ? 0 : 1 + stage / shape.interval.achieved;
}

/// A module that ends a loop by what comes later would begin other iterations.
void require_same_ends(timing::ProcessTiming const& process, timing::ProcessTiming const& variant) {
    each_noted(process, &timing::LoopNotes::ends, [&](unsigned loop, unsigned port) {
        std::uint64_t const recorded = begun_before(process, loop, port);
        std::uint64_t const begun = begun_before(variant, loop, port);
        if (begun != recorded)
            throw NotRetimable(fmt::format(
                "module {} may end its loop {} by what it accesses of {} in a later stage, before which {} of its "
                "iterations begin, expected {}, as in the recorded run; use {} run for others",
                process.name(), process.loops()[loop].name, process.fifo(port).name(), begun, recorded,
                program_name()));
    });
}

}  // namespace

std::unique_ptr<timing::PhraseCore> core_variant(timing::CoreTiming const& blueprint, Machine const& machine) {
    std::unique_ptr<timing::PhraseCore> core = timing::make_core();
    build_core(*core, machine, streams_of(blueprint, machine));
    for (timing::ProcessTiming const& process : blueprint.processes()) {
        timing::ProcessTiming& variant = core->process(process.index());
        require_first_reads(process, variant);
        require_same_ends(process, variant);
        copy_sites(process, variant);
    }
    return core;
}

}  // namespace dataflow::replay
