#include "modules/edge_map_builder/edge_map_output.hpp"

#include "channels/port_binding.hpp"
#include "faster/dataflow_names.hpp"
#include "modules/core/conditions.hpp"
#include "modules/core/token_widths.hpp"

namespace faster {

ModuleDescription EdgeMapOutput::describe(AcceleratorConfig const& config) {
    ModuleDescription module("edge_map_output");
    module.only_if(finds_edges_while_drawing(config));
    module.only_if(has_map_buffers(config, true));
    module.reads_from("map_full");
    module.writes_to("map_free")
        .carries("maps read out, from the edge map output to the edge map builder (edge_map.buffers 2)")
        .of_bits(wires::buffer);
    module.ends.push_back(EdgeMapReadOut::described_end(config));
    module.loops.push_back(EdgeMapReadOut::described_loop(config).with_keys_of("edge_map_builder.output"));
    return module;
}

EdgeMapOutput::EdgeMapOutput(sc_core::sc_module_name const& name, CoreContext const& core, EdgeMapBuffers& buffers)
    : CoreModule(name, core), buffers_(buffers), read_out_(clock_) {}

void EdgeMapOutput::connect() { read_out_.connect(channel_of(edge_map_out)); }

void EdgeMapOutput::work(std::size_t /*i*/) {
    FullMaps const full = take();
    clock_.advance(1);
    read_out_.send(*buffers_.claim(full.buffer.number), core_.rows_of(box_of(full.region)));
    buffers_.release(full.buffer.number);
}

/// Taking a full buffer frees the other one, which has been read out by now.
FullMaps EdgeMapOutput::take() {
    Step const step(clock_);
    FullMaps const full = map_full_in.read();
    map_free_out.write(BufferNumber(buffers_.after(full.buffer.number)));
    return full;
}

}  // namespace faster
