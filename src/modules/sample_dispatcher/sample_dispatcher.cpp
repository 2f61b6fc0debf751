#include "modules/sample_dispatcher/sample_dispatcher.hpp"

#include "channels/port_binding.hpp"
#include "faster/dataflow_names.hpp"
#include "modules/core/memory_entries.hpp"
#include "modules/core/token_widths.hpp"

namespace faster {

ModuleDescription SampleDispatcher::describe() {
    ModuleDescription module("sample_dispatcher");
    module.writes_to("sample_vertex")
        .carries("sample headers from the dispatcher to the vertex transform")
        .of_bits(wires::header);
    module.writes_to("sample_raster")
        .carries("sample headers from the dispatcher to the rasterizer")
        .of_bits(wires::header);
    module.writes_to("sample_observation")
        .carries("sample headers from the dispatcher to the observation reader")
        .of_bits(wires::header);
    module.fetches("header").brings("headers of samples").prefetches(timing::Prefetch::all).headers();
    return module;
}

void SampleDispatcher::start() {
    for (std::size_t i = 0; clock_.uses_memory() && i < core_.sample_count; ++i)
        clock_.tell_entry(header_entry(core_.config.memory_placement, i, core_.first_sample + i));
}

void SampleDispatcher::work(std::size_t i) {
    SampleInput const& sample = core_.sample(i);
    SampleHeader const header{static_cast<std::uint32_t>(core_.first_sample + i), sample.centre_row, sample.centre_col,
                              sample.triangle_count};
    {
        Step const step(clock_);
        clock_.access_memory();
        sample_vertex_out.write(header);
        sample_raster_out.write(header);
        sample_observation_out.write(header);
    }
    clock_.advance(1);
}

}  // namespace faster
