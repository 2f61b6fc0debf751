#include <catch2/catch.hpp>
#include <filesystem>
#include <functional>

#include "dataflow/run/config/load_config.hpp"
#include "dataflow/tools/sweeps/point_identity.hpp"
#include "faster/config/faster_config.hpp"
#include "faster/dataflow_names.hpp"
#include "support/input_error_text.hpp"
#include "support/temp_folder.hpp"

namespace sweep_identity_test {

using namespace faster;
using namespace faster::test;
using sweeps::Identifier;
using sweeps::PointIdentity;

PointIdentity identity_of(RunConfig const& config) { return Identifier().identity(config); }

PointIdentity with(std::function<void(RunConfig&)> const& change) {
    RunConfig config;
    change(config);
    return identity_of(config);
}

TEST_CASE("Timing keys make another point of the same function", "[sweeps]") {
    PointIdentity const plain = identity_of({});
    PointIdentity const deep = with([](RunConfig& config) { config.machine().fifo("sample_observation").depth = 7; });
    CHECK(deep.point != plain.point);
    CHECK(deep.function == plain.function);
    PointIdentity const cores = with([](RunConfig& config) { config.machine().cores = 7; });
    CHECK(cores.point != plain.point);
    CHECK(cores.function == plain.function);
    PointIdentity const samples = with([](RunConfig& config) { workload_of(config).samples.count = 7; });
    CHECK(samples.point != plain.point);
    CHECK(samples.function != plain.function);
}

TEST_CASE("Partitions of a block RAM are part of the function where they decide how long clearing takes", "[sweeps]") {
    auto const identity = [](MapClearing clearing, std::string const& banks) {
        LoadedConfig loaded = layered_config({}, {"accelerator.brams.depth_buffer.partition.type=cyclic",
                                                  "accelerator.brams.depth_buffer.partition.factor=" + banks});
        accelerator_of(loaded.config).inlier_unit.clearing = clearing;
        return identity_of(loaded.config);
    };
    CHECK(identity(MapClearing::loop, "2").function == identity(MapClearing::loop, "4").function);
    CHECK(identity(MapClearing::loop, "2").point != identity(MapClearing::loop, "4").point);
    CHECK(identity(MapClearing::wide, "2").function != identity(MapClearing::wide, "4").function);
}

TEST_CASE("Which iterations wait for writes is part of the function", "[sweeps]") {
    auto const identity = [](HazardHandling hazards, Cycles write_stage) {
        return with([=](RunConfig& config) {
            DependenceSettings& dependence = config.machine().dependence("inlier_unit.fragment.depth_buffer");
            dependence.hazards = hazards;
            dependence.write_stage = write_stage;
        });
    };
    PointIdentity const waits = identity(HazardHandling::interlock, 9);
    CHECK(waits.function != identity(HazardHandling::interlock, 8).function);
    CHECK(waits.function != identity(HazardHandling::report, 9).function);
    CHECK(identity(HazardHandling::report, 9).function == identity(HazardHandling::forward, 8).function);
    CHECK(identity(HazardHandling::report, 9).point != identity(HazardHandling::forward, 9).point);
}

TEST_CASE("The engine is no part of a point", "[sweeps]") {
    CHECK(with([](RunConfig& config) { config.simulation.engine = Engine::lockstep; }).point == identity_of({}).point);
}

TEST_CASE("Files count by their content, not by their name", "[sweeps]") {
    TempFolder const folder;
    folder.write("a.obj", "v 0 0 0\n");
    folder.write("b.obj", "v 0 0 0\n");
    folder.write("c.obj", "v 0 0 1\n");
    folder.write("a.ply", "v 0 0 0\n");
    auto const check = [&](std::function<void(RunConfig&, std::string const&)> const& use) {
        auto const identity = [&](std::string const& name) {
            return with([&](RunConfig& config) { use(config, (folder / name).string()); });
        };
        PointIdentity const a = identity("a.obj");
        CHECK(identity("b.obj").point == a.point);
        CHECK(identity("c.obj").point != a.point);
        CHECK(identity("c.obj").function != a.function);
        CHECK(input_error_text([&] { identity("none.obj"); }) != "(no error)");
    };
    check([](RunConfig& config, std::string const& file) { workload_of(config).target.object = file; });
    check([](RunConfig& config, std::string const& file) { workload_of(config).scene.depth_image = file; });
    check([](RunConfig& config, std::string const& file) { workload_of(config).scene.objects = {{file, {}, {}}}; });
    auto const mesh = [&](std::string const& name) {
        return with([&](RunConfig& config) { workload_of(config).target.object = (folder / name).string(); }).point;
    };
    CHECK(mesh("a.obj") != mesh("a.ply"));  // the ending says how it is read
}

TEST_CASE("A trace counts by the content of all of its files", "[sweeps]") {
    TempFolder const folder;
    folder.write("trace.yaml",
                 "format: faster-trace\nversion: 1\nwidth: 8\nheight: 8\nwindow: 4\n"
                 "fraction: {vertex_xy: 4, vertex_z: 14, area_reciprocal: 30, fragment_depth: 18, depth_buffer: 9}\n"
                 "files: {samples: samples.csv, triangles: triangles.csv, depth: depth.png, edges: edges.png}\n");
    for (char const* const file : {"samples.csv", "triangles.csv", "depth.png", "edges.png"})
        folder.write(file, "1");
    auto const id = [&] {
        return with([&](RunConfig& config) { workload_of(config).trace = folder.path().string(); }).point;
    };
    std::string const before = id();
    CHECK(id() == before);
    for (char const* const file : {"samples.csv", "triangles.csv", "depth.png", "edges.png"}) {
        folder.write(file, "2");
        CHECK(id() != before);
        folder.write(file, "1");
    }
    CHECK(id() == before);
}

}  // namespace sweep_identity_test
