#include "modules/raster_core.hpp"

#include "modules/core_shapes.hpp"

namespace faster {

RasterCore::RasterCore(sc_core::sc_module_name const& name, AcceleratorConfig const& config, Stimulus const& stimulus,
                       CoreShare share, TimeBase const& time_base)
    : sc_module(name),
      context_{config, stimulus, time_base, share.first, share.count, timing_, nullptr, {}, {}, {}, nullptr, &done_},
      edge_map_buffers_(make_edge_map_buffers(config.edge_map, stimulus.window)),
      depth_buffers_(make_depth_buffers(config.inlier_unit.buffers, context_.window_pixels())),
      sample_dispatcher("sample_dispatcher", context_),
      vertex_transform("vertex_transform", context_),
      rasterizer("rasterizer", context_),
      area_reciprocal_unit("area_reciprocal_unit", context_),
      edge_map_builder(make_part<EdgeMapBuilder>(ModuleId::edge_map_builder, edge_map_buffers_)),
      observation_reader("observation_reader", context_),
      inlier_unit("inlier_unit", context_, depth_buffers_),
      result_collector("result_collector", context_),
      edge_map_output(make_part<EdgeMapOutput>(ModuleId::edge_map_output, edge_map_buffers_)),
      inlier_sweep(make_part<InlierSweep>(ModuleId::inlier_sweep, depth_buffers_)) {
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

/// What is not there keeps its place in the core's table of processes, unless it would be at the end: the numbers of
/// the others rely on it.
template <class Module, class Buffers> std::unique_ptr<Module> RasterCore::make_part(ModuleId id, Buffers& buffers) {
    if (has_part(parts(), id))
        return std::make_unique<Module>(name_of(id), context_, buffers);
    if (index_of(id) < process_places(parts()))
        timing_.add_process(name_of(id));
    return nullptr;
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

std::vector<FifoChannel*> RasterCore::channels() {
    return {&sample_vertex_,
            &sample_raster_,
            &sample_observation_,
            &vertex_,
            &area_,
            &area_reciprocal_,
            &command_,
            &fragment_depth_.channel(),
            &fragment_index_.channel(),
            &edge_token_.channel(),
            &edge_map_,
            &observed_depth_,
            &observed_edge_,
            &result_,
            &region_,
            &valid_depth_,
            &map_full_,
            &map_free_,
            &depth_full_,
            &depth_free_};
}

timing::FifoShape RasterCore::fifo_shape_of(FifoId id) const { return fifo_shape(id, context_.config); }

}  // namespace faster
