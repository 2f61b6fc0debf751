#pragma once
#include <systemc>

#include "channels/token_loop.hpp"
#include "faster/data/tokens.hpp"
#include "faster/dataflow_names.hpp"
#include "modules/core/core_module.hpp"
#include "modules/vertex_transform/project_vertices.hpp"

namespace faster {

/// Brings a sample's triangles into the rasterizer's formats: from the mesh under the sample's pose, or from a trace.
///   in    sample_vertex_in  one header per sample
///   out   vertex_out        three vertices per triangle, in mesh order
///   time  loop `vertex`, one vertex per iteration
/// Source: docs/function.md#vertex-transform, docs/timing-model.md#sources-of-time (the thesis does not time its vertex
/// stage).
class VertexTransform : public CoreModule {
  public:
    sc_core::sc_fifo_in<SampleHeader> sample_vertex_in{"sample_vertex_in"};
    sc_core::sc_fifo_out<VertexCode> vertex_out{"vertex_out"};

    static ModuleDescription describe(AcceleratorConfig const& config);

    VertexTransform(sc_core::sc_module_name const& name, CoreContext const& core);

  private:
    void connect() override;
    void start() override;
    void work(std::size_t i) override;
    TriangleCode const* triangles_of(SampleHeader const& header);
    void send(TriangleCode const* triangles, std::size_t count);

    datapath::VertexTransformer transformer_;
    std::vector<TriangleCode> triangles_;
    TokenLoop<Reads<>, Writes<VertexCode>> vertex_;
};

}  // namespace faster
