#include "modules/edge_map_builder/edge_map_builder.hpp"

#include <algorithm>

#include "channels/port_binding.hpp"
#include "modules/edge_map_builder/map_accesses.hpp"

namespace faster {

ModuleDescription EdgeMapBuilder::describe(int window) {
    EdgeMapDesign const& design = design_of(EdgeMapAlgorithm::dual_map);
    ModuleDescription module("edge_map_builder");
    module.reads_from("edge_token");
    module.writes_to("edge_map")
        .carries("edge bits from the edge map builder to the inlier unit")
        .of_bits(1)
        .leaves("output", 2);
    touch_maps(
        module.loop("clear").does("clears one pixel of both maps, or one of every bank, per iteration").of_depth(2),
        design.clear);
    add_token_branches(module.loop("token")
                           .does("takes one edge token per iteration, or finishes the object token before it")
                           .of_depth(4),
                       design);
    touch_maps(module.loop("output").does("sends one token of edge bits per iteration").of_depth(3), design.output);
    auto const side = static_cast<std::uint64_t>(window);
    auto const keep = [&](char const* name, char const* contents, std::uint64_t bits) {
        module.memory(name).holds(contents).of_words(side, side, bits).sized_by("accelerator.window");
    };
    keep("edge_map", "edge bits of the window", design.bits.edge_map);
    keep("object_map", "object bits of the window", design.bits.object_map);
    return module;
}

EdgeMapBuilder::EdgeMapBuilder(sc_core::sc_module_name const& name, CoreContext const& core)
    : CoreModule(name, core), maps_(core.stimulus.window) {}

void EdgeMapBuilder::connect() {
    token_.connect(clock_, "token", &channel_of(edge_token_in));
    output_.connect(clock_, "output", &channel_of(edge_map_out));
    watched_.watch({clock_.write_distances("token", "edge_map"), clock_.write_distances("token", "object_map")});
}

void EdgeMapBuilder::work(std::size_t i) {
    clock_.advance(1);
    clear();
    build();
    core_.show_edge_maps(i, {maps_.edge(), maps_.object(), maps_.side()});
    clock_.advance(1);
    send();
}

void EdgeMapBuilder::clear() {
    maps_.clear();
    clock_.pipeline("clear", core_.window_pixels());
}

void EdgeMapBuilder::build() {
    clock_.here();
    EdgeToken current = edge_token_in.read();
    clock_.advance(1);
    if (current.kind == EdgeTokenKind::End) {
        clock_.advance(1);
        return;
    }
    token_.run_mixed([&](unsigned most, EdgeToken const* next) {
        return watched_.take(maps_, current, next, most, core_.config.edge_map.flush_last);
    });
}

void EdgeMapBuilder::send() {
    output_.run(core_.window_pixels(), [&](std::size_t first, std::size_t count, std::uint8_t* bits) {
        std::copy_n(maps_.edge() + first, count, bits);
    });
}

}  // namespace faster
