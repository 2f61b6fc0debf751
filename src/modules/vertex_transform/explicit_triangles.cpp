#include "modules/vertex_transform/explicit_triangles.hpp"

#include "modules/vertex_transform/project_vertices.hpp"

namespace faster {

Stimulus with_explicit_triangles(Stimulus stimulus) {
    if (!stimulus.is_posed())
        return stimulus;
    datapath::VertexTransformer transformer(stimulus.posed, stimulus.fraction);
    std::vector<TriangleCode> triangles;
    for (std::size_t i = 0; i < stimulus.samples.size(); ++i) {
        transformer.transform(i, triangles);
        stimulus.samples[i].first_triangle = static_cast<std::uint32_t>(stimulus.triangles.size());
        stimulus.samples[i].triangle_count = static_cast<std::uint32_t>(triangles.size());
        stimulus.triangles.insert(stimulus.triangles.end(), triangles.begin(), triangles.end());
    }
    stimulus.posed = PosedMesh{};
    return stimulus;
}

}  // namespace faster
