#include "modules/edge_map_output.hpp"

#include "channels/port_binding.hpp"

namespace faster {

EdgeMapOutput::EdgeMapOutput(sc_core::sc_module_name const& name, CoreContext const& core, EdgeMapBuffers& buffers)
    : sc_module(name),
      core_(core),
      clock_(core.timing, basename(), core.time_base),
      buffers_(buffers),
      read_out_(core, clock_) {
    SC_THREAD(run);
}

void EdgeMapOutput::end_of_elaboration() {
    clock_.connect_reads(channel_of(map_full_in));
    clock_.connect_writes(channel_of(map_free_out));
    clock_.connect_writes(channel_of(edge_map_out));
    read_out_.add_loop(channel_of(edge_map_out));
}

void EdgeMapOutput::run() {
    for (std::size_t i = 0; i < core_.sample_count; ++i) {
        core_.begin_sample(ModuleId::edge_map_output);
        FullMaps const full = take();
        clock_.advance(1);
        read_out_.send(*buffers_.claim(full.buffer.number), core_.rows_of(box_of(full.region)));
        buffers_.release(full.buffer.number);
    }
}

/// Whoever takes the next buffer has done with the one before.
FullMaps EdgeMapOutput::take() {
    Step const step(clock_);
    FullMaps const full = map_full_in.read();
    map_free_out.write(BufferNumber(buffers_.after(full.buffer.number)));
    return full;
}

}  // namespace faster
