#include "tb/workload_source.hpp"

#include "datapath/vertex_transform.hpp"
#include "faster/adopt_trace.hpp"
#include "faster/faster_config.hpp"
#include "workload/build_stimulus.hpp"
#include "workload/files/trace.hpp"
#include "workload/object_mesh.hpp"

namespace faster {

Stimulus load_stimulus(LoadedConfig& loaded) {
    WorkloadConfig const& config = workload_of(loaded.config);
    AcceleratorConfig const& accelerator = accelerator_of(loaded.config);
    if (config.trace.empty()) {
        Stimulus stimulus = workload::build_stimulus(config, accelerator.window, accelerator.fraction_bits);
        if (!config.samples.poses.empty())
            adopt_poses(loaded, stimulus.samples.size());
        return stimulus;
    }
    Stimulus stimulus = io::read_trace(config.trace);
    adopt_trace(loaded, stimulus.width, stimulus.height, stimulus.window, stimulus.fraction);
    return stimulus;
}

std::vector<std::string> stimulus_warnings(Stimulus const& stimulus, WorkloadConfig const& config) {
    if (!config.trace.empty() || !workload::is_mesh_file(config.target.object))
        return {};
    std::string const warning = workload::size_warning(stimulus.posed.mesh, config.target.object);
    return warning.empty() ? std::vector<std::string>{} : std::vector<std::string>{warning};
}

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
