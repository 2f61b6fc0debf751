#include "modules/inlier_sweep.hpp"

namespace faster {

InlierSweep::InlierSweep(sc_core::sc_module_name const& name, CoreContext const& core, DepthBuffers& buffers)
    : sc_module(name),
      core_(core),
      clock_(core.timing, basename(), core.time_base),
      buffers_(buffers),
      scoring_(core, clock_) {
    SC_THREAD(run);
}

void InlierSweep::end_of_elaboration() {
    clock_.connect_reads(channel_of(depth_full_in));
    clock_.connect_writes(channel_of(depth_free_out));
    scoring_.connect(channel_of(edge_map_in), channel_of(observed_depth_in), channel_of(observed_edge_in));
    clock_.connect_writes(channel_of(result_out));
    scoring_.add_loops();
}

void InlierSweep::run() {
    for (std::size_t i = 0; i < core_.sample_count; ++i) {
        core_.begin_sample(ModuleId::inlier_sweep);
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
}

/// Whoever takes the next buffer has done with the one before.
FullDepthBuffer InlierSweep::take() {
    Step const step(clock_);
    FullDepthBuffer const full = depth_full_in.read();
    depth_free_out.write(BufferNumber(buffers_.after(full.buffer.number)));
    return full;
}

}  // namespace faster
