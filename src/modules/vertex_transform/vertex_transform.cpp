#include "modules/vertex_transform/vertex_transform.hpp"

#include "channels/port_binding.hpp"
#include "faster/dataflow_names.hpp"
#include "modules/core/conditions.hpp"
#include "modules/core/memory_entries.hpp"
#include "modules/core/token_widths.hpp"

namespace faster {

ModuleDescription VertexTransform::describe(AcceleratorConfig const& config) {
    ModuleDescription module("vertex_transform");
    module.reads_from("sample_vertex");
    module.writes_to("vertex")
        .carries("vertices from the vertex transform to the rasterizer")
        .of_bits(2 * wires::vertex_xy + wires::vertex_z)
        .leaves("vertex", 40);
    module.loop("vertex")
        .does("transforms one vertex per iteration")
        .of_depth(41)
        .writes_to({"vertex"})
        .accesses_memory("mesh", {{{0, 0}}, {}});
    module.memory("mesh")
        .holds("vertices of the mesh, three per triangle, if it is on the chip")
        .of_words(1, 3 * config.memory_placement.mesh_triangles, 2 * wires::vertex_xy + wires::vertex_z)
        .loaded_before()
        .only_if(has_external_memory(config))
        .only_if({config.memory_placement.mesh == Placement::on_chip, "accelerator.memory.mesh"});
    module.fetches("vertex")
        .brings("vertices of the mesh")
        .taken_by("vertex")
        .prefetches(timing::Prefetch::handed)
        .only_if({config.memory_placement.mesh == Placement::external, "accelerator.memory.mesh"});
    return module;
}

VertexTransform::VertexTransform(sc_core::sc_module_name const& name, CoreContext const& core)
    : CoreModule(name, core), transformer_(core.stimulus.posed, core.stimulus.fraction) {}

void VertexTransform::connect() {
    vertex_.connect(clock_, "vertex", &channel_of(vertex_out));
    vertex_.also_accesses(clock_.memory_port());
}

void VertexTransform::start() {
    for (std::size_t i = 0; clock_.uses_memory() && i < core_.sample_count; ++i)
        if (core_.sample(i).triangle_count > 0)
            clock_.tell_entry(mesh_entry(core_.config.memory_placement, i, core_.sample(i).triangle_count));
}

void VertexTransform::work(std::size_t /*i*/) {
    clock_.here();
    SampleHeader const header = sample_vertex_in.read();
    clock_.advance(1);
    if (header.triangles > 0)
        send(triangles_of(header), header.triangles);
    else
        clock_.advance(1);
}

TriangleCode const* VertexTransform::triangles_of(SampleHeader const& header) {
    if (!core_.stimulus.is_posed())
        return core_.stimulus.triangles.data() + core_.stimulus.samples[header.sample].first_triangle;
    transformer_.transform(header.sample, triangles_);
    return triangles_.data();
}

void VertexTransform::send(TriangleCode const* triangles, std::size_t count) {
    vertex_.run(3 * count, [&](std::size_t first, std::size_t n, VertexCode* out) {
        for (std::size_t i = first; i < first + n; ++i)
            *out++ = triangles[i / 3].vertex[i % 3];
    });
}

}  // namespace faster
