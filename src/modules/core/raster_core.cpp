#include "modules/core/raster_core.hpp"

#include "faster/data/sample_counters.hpp"
#include "modules/core/core_resources.hpp"
#include "modules/core/raster_core_activity.hpp"

namespace faster {

CoreDescription describe_raster_core(AcceleratorConfig const& config) {
    CoreDescription core;
    core.modules = {SampleDispatcher::describe(),     VertexTransform::describe(config),
                    Rasterizer::describe(config),     AreaReciprocal::describe(config),
                    EdgeMapBuilder::describe(config), ObservationReader::describe(config),
                    InlierUnit::describe(config),     ResultCollector::describe(config),
                    EdgeMapOutput::describe(config),  InlierSweep::describe(config)};
    // In the order of the tables (docs/formats.md#fifoscsv-one-row-per-core-and-fifo).
    core.fifos = {"sample_vertex",   "sample_raster",  "sample_observation", "vertex",         "area",
                  "area_reciprocal", "command",        "fragment_depth",     "fragment_index", "edge_token",
                  "edge_map",        "observed_depth", "observed_edge",      "result",         "region",
                  "valid_depth",     "map_full",       "map_free",           "depth_full",     "depth_free"};
    core.cores_are = "raster cores";
    core.remark = "window " + std::to_string(config.window) + " x " + std::to_string(config.window) + " px";
    core.begins = "rasterizer";
    core.ends = "result_collector";
    core.is_over_with_last_sample = true;
    core.pace = {"rasterizer",
                 {{"vertex_transform", "vertex"},
                  {"area_reciprocal", "area"},
                  {"edge_map_builder", "edge_token"},
                  {"inlier_unit", "command"}}};
    core.resources = [config](Machine const& machine) { return core_resources(config, machine); };
    return core;
}

RasterCore::RasterCore(sc_core::sc_module_name const& name, AcceleratorConfig const& config, Stimulus const& stimulus,
                       std::shared_ptr<Machine const> machine, CoreShare share, TimeBase const& time_base)
    : DataflowCore(name, std::move(machine), share, time_base),
      context_{config, stimulus, *this, share.first, share.count, nullptr},
      edge_map_buffers_(make_edge_map_buffers(config.edge_map, stimulus.window)),
      depth_buffers_(make_depth_buffers(config.inlier_unit.buffers, context_.window_pixels())),
      sample_dispatcher("sample_dispatcher", context_),
      vertex_transform("vertex_transform", context_),
      rasterizer("rasterizer", context_),
      area_reciprocal_unit("area_reciprocal_unit", context_),
      edge_map_builder(make_part<EdgeMapBuilder>("edge_map_builder", edge_map_buffers_)),
      observation_reader("observation_reader", context_),
      inlier_unit("inlier_unit", context_, depth_buffers_),
      result_collector("result_collector", context_),
      edge_map_output(make_part<EdgeMapOutput>("edge_map_output", edge_map_buffers_)),
      inlier_sweep(make_part<InlierSweep>("inlier_sweep", depth_buffers_)) {
    sample_dispatcher.sample_vertex_out(sample_vertex_);
    sample_dispatcher.sample_raster_out(sample_raster_);
    sample_dispatcher.sample_observation_out(sample_observation_);

    vertex_transform.sample_vertex_in(sample_vertex_);
    vertex_transform.vertex_out(vertex_);

    rasterizer.sample_raster_in(sample_raster_);
    rasterizer.vertex_in(vertex_);
    rasterizer.area_out(area_);
    rasterizer.command_out(command_);
    fragment_depth_.bind(rasterizer.fragment_depth_out, inlier_unit.fragment_depth_in);
    fragment_index_.bind(rasterizer.fragment_index_out, inlier_unit.fragment_index_in);

    area_reciprocal_unit.area_in(area_);
    area_reciprocal_unit.area_reciprocal_out(area_reciprocal_);

    if (edge_map_builder != nullptr)
        bind_edge_maps();

    observation_reader.sample_observation_in(sample_observation_);
    observation_reader.observed_depth_out(observed_depth_);
    observation_reader.observed_edge_out(observed_edge_);

    inlier_unit.area_reciprocal_in(area_reciprocal_);
    inlier_unit.command_in(command_);
    bind_scoring();

    result_collector.result_in(result_);

    if (context_.sweeps_touched()) {
        rasterizer.region_out(region_);
        observation_reader.region_in(region_);
        observation_reader.valid_depth_out(valid_depth_);
        result_collector.valid_depth_in(valid_depth_);
    }
}

template <class Module, class Buffers>
std::unique_ptr<Module> RasterCore::make_part(char const* module, Buffers& buffers) {
    if (!machine().processes[machine().process(module)].is_present)
        return nullptr;
    return std::make_unique<Module>(module, context_, buffers);
}

void RasterCore::bind_edge_maps() {
    edge_token_.bind(rasterizer.edge_token_out, edge_map_builder->edge_token_in);
    if (edge_map_output == nullptr) {
        edge_map_builder->edge_map_out(edge_map_);
        return;
    }
    edge_map_builder->map_full_out(map_full_);
    edge_map_builder->map_free_in(map_free_);
    edge_map_output->map_full_in(map_full_);
    edge_map_output->map_free_out(map_free_);
    edge_map_output->edge_map_out(edge_map_);
}

void RasterCore::bind_scoring() {
    auto const bind = [this](auto& module) {
        if (edge_map_builder != nullptr)
            module.edge_map_in(edge_map_);
        module.observed_depth_in(observed_depth_);
        module.observed_edge_in(observed_edge_);
        module.result_out(result_);
    };
    if (inlier_sweep == nullptr)
        return bind(inlier_unit);
    bind(*inlier_sweep);
    inlier_unit.depth_full_out(depth_full_);
    inlier_unit.depth_free_in(depth_free_);
    inlier_sweep->depth_full_in(depth_full_);
    inlier_sweep->depth_free_out(depth_free_);
}

Counters RasterCore::result(std::size_t i) const { return values_of(result_collector.results()[i]); }

/// By these the rasterizer can be ahead of the last process, and one: all get their headers in one step, and the
/// observation reader's tokens keep it near the inlier unit. Where a sample may have none, its valid depths keep it
/// near the result collector.
std::size_t RasterCore::most_samples_ahead() const {
    auto const capacity = [this](char const* fifo) { return machine().fifos[machine().fifo(fifo)].shape().capacity; };
    std::uint64_t const headers = capacity("sample_observation");
    if (context_.sweeps_touched())
        return headers + capacity("valid_depth") + 4;
    return headers + capacity("observed_depth") / context_.window_rows().tokens() + 4;
}

std::unique_ptr<recording::MemoryActivity> RasterCore::memory_activity() const {
    return std::make_unique<RasterCoreActivity>(context_.config, machine());
}

}  // namespace faster
