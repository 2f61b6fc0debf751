#include "modules/sample_dispatcher.hpp"

#include "channels/port_binding.hpp"

namespace faster {

SampleDispatcher::SampleDispatcher(sc_core::sc_module_name const& name, CoreContext const& core)
    : sc_module(name), core_(core), clock_(core.timing, basename(), core.time_base) {
    SC_THREAD(run);
}

void SampleDispatcher::end_of_elaboration() {
    clock_.connect_writes(channel_of(sample_vertex_out));
    clock_.connect_writes(channel_of(sample_raster_out));
    clock_.connect_writes(channel_of(sample_observation_out));
}

void SampleDispatcher::run() {
    if (core_.turn != nullptr)
        wait(*core_.turn);
    for (std::size_t i = 0; i < core_.sample_count; ++i) {
        core_.begin_sample(ModuleId::sample_dispatcher);
        SampleInput const& sample = core_.sample(i);
        SampleHeader const header{static_cast<std::uint32_t>(core_.first_sample + i), sample.centre_row,
                                  sample.centre_col, sample.triangle_count};
        {
            Step const step(clock_);
            sample_vertex_out.write(header);
            sample_raster_out.write(header);
            sample_observation_out.write(header);
        }
        clock_.advance(1);
    }
}

}  // namespace faster
