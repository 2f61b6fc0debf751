#include "modules/vertex_transform.hpp"

#include <algorithm>

#include "channels/port_binding.hpp"
#include "modules/core_shapes.hpp"

namespace faster {

VertexTransform::VertexTransform(sc_core::sc_module_name const& name, CoreContext const& core)
    : sc_module(name),
      core_(core),
      clock_(core.timing, basename(), core.time_base),
      transformer_(core.stimulus.posed, core.stimulus.fraction) {
    SC_THREAD(run);
}

void VertexTransform::end_of_elaboration() {
    clock_.connect_reads(channel_of(sample_vertex_in));
    clock_.connect_writes(channel_of(vertex_out));
    vertex_loop_ = clock_.add_loop(loop_shape(LoopId::vertex, core_.config), {&channel_of(vertex_out)});
}

void VertexTransform::run() {
    for (std::size_t i = 0; i < core_.sample_count; ++i) {
        core_.begin_sample(ModuleId::vertex_transform);
        clock_.here();
        SampleHeader const header = sample_vertex_in.read();
        clock_.advance(1);
        if (header.triangles > 0)
            send(triangles_of(header), header.triangles);
        else
            clock_.advance(1);
    }
}

TriangleCode const* VertexTransform::triangles_of(SampleHeader const& header) {
    if (!core_.stimulus.is_posed())
        return core_.stimulus.triangles.data() + core_.stimulus.samples[header.sample].first_triangle;
    transformer_.transform(header.sample, triangles_);
    return triangles_.data();
}

void VertexTransform::send(TriangleCode const* triangles, std::size_t count) {
    constexpr std::size_t burst = 256;  // triangles
    auto& vertices = channel_of(vertex_out);
    clock_.enter_loop(vertex_loop_);
    for (std::size_t done = 0; done < count;) {
        std::size_t const n = std::min(burst, count - done);
        vertices.await_room();
        VertexCode* out = vertices.reserve(3 * n);
        for (std::size_t i = 0; i < n; ++i)
            out = std::copy_n(triangles[done + i].vertex, 3, out);
        vertices.commit(3 * n);
        clock_.iterate(vertices.write_port(), 3 * n);
        done += n;
    }
    clock_.leave_loop();
}

}  // namespace faster
