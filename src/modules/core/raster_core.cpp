#include "modules/core/raster_core.hpp"

#include "faster/data/sample_counters.hpp"
#include "modules/core/core_resources.hpp"
#include "modules/edge_map_builder/edge_map_builder.hpp"
#include "modules/edge_map_builder/edge_map_builder_variant.hpp"
#include "modules/edge_map_builder/edge_map_output.hpp"
#include "modules/edge_map_builder/map_activity.hpp"
#include "modules/inlier_unit/depth_activity.hpp"
#include "modules/inlier_unit/inlier_sweep.hpp"
#include "modules/inlier_unit/inlier_unit.hpp"
#include "modules/inlier_unit/inlier_unit_variant.hpp"
#include "modules/rasterizer/rasterizer.hpp"
#include "modules/rasterizer/rasterizer_variant.hpp"

namespace faster {

CoreDescription describe_raster_core(AcceleratorConfig const& config) {
    CoreDescription core;
    // A variant's description is the thesis's with what the configuration changes; with the defaults, nothing.
    core.modules = {SampleDispatcher::describe(),
                    VertexTransform::describe(config),
                    RasterizerVariant::describe(config),
                    AreaReciprocal::describe(config),
                    EdgeMapBuilderVariant::describe(config),
                    ObservationReader::describe(config),
                    InlierUnitVariant::describe(config),
                    ResultCollector::describe(config),
                    EdgeMapOutput::describe(config),
                    InlierSweep::describe(config)};
    // In the order of the tables (docs/formats.md).
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
      sample_dispatcher_("sample_dispatcher", context_),
      vertex_transform_("vertex_transform", context_),
      rasterizer_(make_rasterizer()),
      area_reciprocal_unit_("area_reciprocal_unit", context_),
      edge_map_builder_(make_edge_map_builder()),
      observation_reader_("observation_reader", context_),
      inlier_unit_(make_inlier_unit()),
      result_collector_("result_collector", context_),
      edge_map_output_(make_edge_map_output()),
      inlier_sweep_(make_inlier_sweep()) {
    sample_dispatcher_.sample_vertex_out(sample_vertex_);
    sample_dispatcher_.sample_raster_out(sample_raster_);
    sample_dispatcher_.sample_observation_out(sample_observation_);

    vertex_transform_.sample_vertex_in(sample_vertex_);
    vertex_transform_.vertex_out(vertex_);

    area_reciprocal_unit_.area_in(area_);
    area_reciprocal_unit_.area_reciprocal_out(area_reciprocal_);

    observation_reader_.sample_observation_in(sample_observation_);
    observation_reader_.observed_depth_out(observed_depth_);
    observation_reader_.observed_edge_out(observed_edge_);

    result_collector_.result_in(result_);

    if (context_.sweeps_touched()) {
        observation_reader_.region_in(region_);
        observation_reader_.valid_depth_out(valid_depth_);
        result_collector_.valid_depth_in(valid_depth_);
    }
}

RasterCore::Module RasterCore::make_rasterizer() {
    if (!RasterizerVariant::is_needed(context_.config)) {
        auto rasterizer = std::make_unique<Rasterizer>("rasterizer", context_);
        join_rasterizer(*rasterizer);
        edge_token_.bind(rasterizer->edge_token_out);
        return rasterizer;
    }
    auto rasterizer = std::make_unique<RasterizerVariant>("rasterizer", context_);
    join_rasterizer(*rasterizer);
    if (has("edge_map_builder"))
        edge_token_.bind(rasterizer->edge_token_out);
    if (context_.sweeps_touched())
        rasterizer->region_out(region_);
    return rasterizer;
}

template <class Rasterizer> void RasterCore::join_rasterizer(Rasterizer& rasterizer) {
    rasterizer.sample_raster_in(sample_raster_);
    rasterizer.vertex_in(vertex_);
    rasterizer.area_out(area_);
    rasterizer.command_out(command_);
    fragment_depth_.bind(rasterizer.fragment_depth_out);
    fragment_index_.bind(rasterizer.fragment_index_out);
}

RasterCore::Module RasterCore::make_edge_map_builder() {
    if (!has("edge_map_builder"))
        return nullptr;
    if (!EdgeMapBuilderVariant::is_needed(context_.config)) {
        auto builder = std::make_unique<EdgeMapBuilder>("edge_map_builder", context_);
        edge_token_.bind(builder->edge_token_in);
        builder->edge_map_out(edge_map_);
        return builder;
    }
    edge_map_buffers_.emplace(make_edge_map_buffers(context_.config.edge_map, context_.stimulus.window));
    auto builder = std::make_unique<EdgeMapBuilderVariant>("edge_map_builder", context_, *edge_map_buffers_);
    edge_token_.bind(builder->edge_token_in);
    if (has("edge_map_output")) {
        builder->map_full_out(map_full_);
        builder->map_free_in(map_free_);
    } else {
        builder->edge_map_out(edge_map_);
    }
    return builder;
}

RasterCore::Module RasterCore::make_edge_map_output() {
    if (!has("edge_map_output"))
        return nullptr;
    auto output = std::make_unique<EdgeMapOutput>("edge_map_output", context_, *edge_map_buffers_);
    output->map_full_in(map_full_);
    output->map_free_out(map_free_);
    output->edge_map_out(edge_map_);
    return output;
}

RasterCore::Module RasterCore::make_inlier_unit() {
    if (!InlierUnitVariant::is_needed(context_.config)) {
        auto unit = std::make_unique<InlierUnit>("inlier_unit", context_);
        join_inlier_unit(*unit);
        join_scoring(*unit);
        return unit;
    }
    depth_buffers_.emplace(make_depth_buffers(context_.config.inlier_unit.buffers, context_.window_pixels()));
    auto unit = std::make_unique<InlierUnitVariant>("inlier_unit", context_, *depth_buffers_);
    join_inlier_unit(*unit);
    if (has("inlier_sweep")) {
        unit->depth_full_out(depth_full_);
        unit->depth_free_in(depth_free_);
    } else {
        join_scoring(*unit);
    }
    return unit;
}

template <class InlierUnit> void RasterCore::join_inlier_unit(InlierUnit& unit) {
    unit.area_reciprocal_in(area_reciprocal_);
    unit.command_in(command_);
    fragment_depth_.bind(unit.fragment_depth_in);
    fragment_index_.bind(unit.fragment_index_in);
}

template <class Sweep> void RasterCore::join_scoring(Sweep& sweep) {
    if (has("edge_map_builder"))
        sweep.edge_map_in(edge_map_);
    sweep.observed_depth_in(observed_depth_);
    sweep.observed_edge_in(observed_edge_);
    sweep.result_out(result_);
}

RasterCore::Module RasterCore::make_inlier_sweep() {
    if (!has("inlier_sweep"))
        return nullptr;
    auto sweep = std::make_unique<InlierSweep>("inlier_sweep", context_, *depth_buffers_);
    join_scoring(*sweep);
    sweep->depth_full_in(depth_full_);
    sweep->depth_free_out(depth_free_);
    return sweep;
}

Counters RasterCore::result(std::size_t i) const { return values_of(result_collector_.results()[i], counters()); }

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

namespace {
/// Each of the two hears of everything, and looks at its own loops.
class Activity : public recording::MemoryActivity {
  public:
    Activity(AcceleratorConfig const& config, Machine const& machine)
        : maps_(config, machine), depths_(config, machine) {}

    void token_read(recording::TokenRead const& read) override {
        maps_.token_read(read);
        depths_.token_read(read);
    }
    void iterated(recording::LoopIteration const& iteration, recording::MemoryPorts& ports) override {
        maps_.iterated(iteration, ports);
        depths_.iterated(iteration, ports);
    }

  private:
    MapActivity maps_;
    DepthActivity depths_;
};
}  // namespace

std::unique_ptr<recording::MemoryActivity> RasterCore::memory_activity() const {
    return std::make_unique<Activity>(context_.config, machine());
}

}  // namespace faster
