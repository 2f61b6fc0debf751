#include "retiming/core_variant.hpp"

#include "config/rasterizer_design.hpp"
#include "modules/core_shapes.hpp"

namespace faster::retiming {

namespace {

timing::LoopShape variant_of(timing::LoopShape const& loop, timing::ProcessTiming const& variant,
                             AcceleratorConfig const& config) {
    timing::LoopShape shape = loop_shape(loop_named(static_cast<ModuleId>(variant.index()), loop.name), config);
    for (timing::LoopWrite const& write : loop.writes)
        shape.writes.push_back({write.port, variant.fifo(write.port).shape().write_latency});
    shape.reads = loop.reads;
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

std::unique_ptr<timing::CoreTiming> core_variant(timing::CoreTiming const& blueprint, AcceleratorConfig const& config) {
    auto core = std::make_unique<timing::CoreTiming>();
    for (std::size_t i = 0; i < blueprint.fifos().size(); ++i)
        core->add_fifo(fifo_shape(static_cast<FifoId>(i), config));
    for (timing::ProcessTiming const& process : blueprint.processes()) {
        timing::ProcessTiming& variant = core->add_process(process.name());
        for (unsigned port = 0; port < process.port_count(); ++port) {
            timing::FifoTiming& fifo = core->fifo(blueprint.number_of(process.fifo(port)));
            process.writes(port) ? variant.add_writes(fifo) : variant.add_reads(fifo);
        }
        for (timing::LoopShape const& loop : process.loops())
            variant.add_loop(variant_of(loop, variant, config));
        copy_sites(process, variant);
        variant.set_setup_cycles(setup_cycles(config));
    }
    return core;
}

}  // namespace faster::retiming
