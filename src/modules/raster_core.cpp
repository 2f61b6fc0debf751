#include "modules/raster_core.hpp"

#include "modules/core_shapes.hpp"

namespace faster {

RasterCore::RasterCore(sc_core::sc_module_name const& name, AcceleratorConfig const& config, Stimulus const& stimulus,
                       CoreShare share, TimeBase const& time_base)
    : sc_module(name),
      context_{config, stimulus, time_base, share.first, share.count, timing_, nullptr, {}, {}, {}, nullptr, &done_},
      sample_dispatcher("sample_dispatcher", context_),
      vertex_transform("vertex_transform", context_),
      rasterizer("rasterizer", context_),
      area_reciprocal_unit("area_reciprocal_unit", context_),
      edge_map_builder(make_edge_map_builder()),
      observation_reader("observation_reader", context_),
      inlier_unit("inlier_unit", context_),
      result_collector("result_collector", context_) {
    sample_dispatcher.sample_vertex_out(sample_vertex_);
    sample_dispatcher.sample_raster_out(sample_raster_);
    sample_dispatcher.sample_observation_out(sample_observation_);

    vertex_transform.sample_vertex_in(sample_vertex_);
    vertex_transform.vertex_out(vertex_);

    rasterizer.sample_raster_in(sample_raster_);
    rasterizer.vertex_in(vertex_);
    rasterizer.area_out(area_);
    rasterizer.command_out(command_);
    rasterizer.fragment_depth_out(fragment_depth_);
    rasterizer.fragment_index_out(fragment_index_);

    area_reciprocal_unit.area_in(area_);
    area_reciprocal_unit.area_reciprocal_out(area_reciprocal_);

    if (edge_map_builder != nullptr) {
        rasterizer.edge_token_out(edge_token_);
        edge_map_builder->edge_token_in(edge_token_);
        edge_map_builder->edge_map_out(edge_map_);
        inlier_unit.edge_map_in(edge_map_);
    }

    observation_reader.sample_observation_in(sample_observation_);
    observation_reader.observed_depth_out(observed_depth_);
    observation_reader.observed_edge_out(observed_edge_);

    inlier_unit.area_reciprocal_in(area_reciprocal_);
    inlier_unit.fragment_depth_in(fragment_depth_);
    inlier_unit.fragment_index_in(fragment_index_);
    inlier_unit.command_in(command_);
    inlier_unit.observed_depth_in(observed_depth_);
    inlier_unit.observed_edge_in(observed_edge_);
    inlier_unit.result_out(result_);

    result_collector.result_in(result_);
}

/// A flow without one keeps its place in the core's table of processes: the numbers of the others rely on it.
std::unique_ptr<EdgeMapBuilder> RasterCore::make_edge_map_builder() {
    if (has_part(parts(), ModuleId::edge_map_builder))
        return std::make_unique<EdgeMapBuilder>("edge_map_builder", context_);
    timing_.add_process(name_of(ModuleId::edge_map_builder));
    return nullptr;
}

std::vector<FifoChannel*> RasterCore::channels() {
    return {&sample_vertex_,   &sample_raster_,  &sample_observation_, &vertex_,         &area_,
            &area_reciprocal_, &command_,        &fragment_depth_,     &fragment_index_, &edge_token_,
            &edge_map_,        &observed_depth_, &observed_edge_,      &result_};
}

timing::FifoShape RasterCore::fifo_shape_of(FifoId id) const { return fifo_shape(id, context_.config); }

}  // namespace faster
