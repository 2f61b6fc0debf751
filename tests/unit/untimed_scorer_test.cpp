#include "modules/core/untimed_scorer.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <random>

#include "faster/reference/scorer.hpp"
#include "faster/workload/build_stimulus.hpp"

namespace untimed_scorer_test {

using namespace faster;

WorkloadConfig small_scene(std::uint32_t seed) {
    std::mt19937 random(seed);
    auto const between = [&random](double low, double high) {
        return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
    };
    WorkloadConfig config;
    char const* const objects[]{"banana", "mug", "tomato_soup_can", "cracker_box"};
    config.target.object = objects[seed % 4];
    config.target.translation_m = {between(-0.4, 0.4), between(-0.3, 0.3), between(0.4, 1.2)};
    config.target.rotation_deg = {between(0, 360), between(0, 360), between(0, 360)};
    config.scene.table = seed % 2 == 0;
    config.samples.count = 6;
    config.samples.rotation_sigma_deg = 60;
    config.samples.translation_sigma_m = 0.03;
    config.samples.seed = seed;
    config.max_triangles = 400;
    config.camera = {160, 120, 140, 140, 79.5, 59.5};
    return config;
}

/// Triangles without neighbours show what each of them sends.
void leave_every(std::size_t stride, Mesh& mesh) {
    std::vector<std::array<std::uint32_t, 3>> left;
    for (std::size_t face = 0; face < mesh.faces.size(); face += stride)
        left.push_back(mesh.faces[face]);
    mesh.faces = left;
}

TEST_CASE("Pixel runs give the counters and maps of the reference, with every edge map it knows", "[untimed_scorer]") {
    std::uint32_t const seed = GENERATE(range(1U, 41U));
    CAPTURE(seed);
    EdgeMapAlgorithm const algorithms[]{EdgeMapAlgorithm::dual_map, EdgeMapAlgorithm::inner_border,
                                        EdgeMapAlgorithm::transition, EdgeMapAlgorithm::bounded,
                                        EdgeMapAlgorithm::dual_map_4_1_2};
    EdgeMapConfig edge_map;
    edge_map.algorithm = algorithms[seed % 5];
    edge_map.flush_last = seed % 3 == 0;
    FractionBits fraction;
    fraction.depth_buffer = seed % 7 == 0 ? 7 : 9;
    fraction.vertex_xy = seed % 3 == 1 ? 0 : 4;  // vertices in the middle of pixels, which are inside then
    Stimulus stimulus = workload::build_stimulus(small_scene(seed), seed % 4 == 3 ? 41 : 64, fraction);
    leave_every(seed % 3 == 1 ? 11 : 1, stimulus.posed.mesh);
    HiddenPixels const hidden = seed % 2 == 0 ? HiddenPixels::counted : HiddenPixels::ignored;
    datapath::UntimedScorer scorer(stimulus, edge_map, hidden);
    reference::Scorer reference(stimulus, edge_map);
    if (hidden == HiddenPixels::counted)
        reference.count_hidden();
    for (std::size_t i = 0; i < stimulus.samples.size(); ++i) {
        CAPTURE(i);
        SampleCounters const counters = scorer.score(stimulus.posed.poses[i], stimulus.samples[i]);
        SampleCounters const expected = reference.run(i);
        CHECK(values_of(counters) == values_of(expected));
        std::vector<std::uint8_t> const& edges = reference.maps().edge_map.pixels();
        CHECK(std::equal(edges.begin(), edges.end(), scorer.edge_maps().edge()));
        CHECK(scorer.depth_buffer() == reference.maps().depth_buffer.pixels());
    }
}

}  // namespace untimed_scorer_test
