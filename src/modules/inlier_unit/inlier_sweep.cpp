#include "modules/inlier_unit/inlier_sweep.hpp"

#include "modules/core/conditions.hpp"
#include "modules/core/token_widths.hpp"

namespace faster {

ModuleDescription InlierSweep::describe(AcceleratorConfig const& config) {
    ModuleDescription module("inlier_sweep");
    module.only_if(has_depth_buffers(config, true));
    module.reads_from("depth_full");
    module.writes_to("depth_free")
        .carries("swept depth buffers from the inlier sweep to the inlier unit (inlier_unit.buffers 2)")
        .of_bits(wires::buffer);
    Scoring::describe(module, config);
    for (LoopDescription& loop : module.loops)
        loop.with_keys_of("inlier_unit." + loop.name);
    return module;
}

InlierSweep::InlierSweep(sc_core::sc_module_name const& name, CoreContext const& core, DepthBuffers& buffers)
    : CoreModule(name, core), buffers_(buffers), scoring_(core, clock_) {}

void InlierSweep::connect() {
    scoring_.connect(channel_of(edge_map_in), channel_of(observed_depth_in), channel_of(observed_edge_in));
}

void InlierSweep::work(std::size_t i) {
    FullDepthBuffer const full = take();
    clock_.advance(1);
    SampleCounters counters;
    counters.valid_raster = full.valid_raster;
    scoring_.score(core_.first_sample + i, buffers_.claim(full.buffer.number), box_of(full.region), counters);
    buffers_.release(full.buffer.number);
    clock_.here();
    result_out.write(counters);
    clock_.advance(1);
}

/// Taking a full buffer frees the other one, which has been read out by now.
FullDepthBuffer InlierSweep::take() {
    Step const step(clock_);
    FullDepthBuffer const full = depth_full_in.read();
    depth_free_out.write(BufferNumber(buffers_.after(full.buffer.number)));
    return full;
}

}  // namespace faster
