#include "faster/workload/sensor_noise.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "dataflow/base/random.hpp"
#include "faster/dataflow_names.hpp"

namespace faster::workload {
namespace {

bool is_depth_edge(DepthImage const& depth, int row, int column, double step_m) {
    constexpr int neighbours[4][2] = {{-1, 0}, {1, 0}, {0, -1}, {0, 1}};
    return std::any_of(std::begin(neighbours), std::end(neighbours), [&](int const(&offset)[2]) {
        int const other_row = row + offset[0];
        int const other_column = column + offset[1];
        return depth.contains(other_row, other_column) &&
               std::abs(depth.at(other_row, other_column) - depth.at(row, column)) > step_m;
    });
}

double axial_sigma_m(double depth_m, NoiseConfig const& config) {
    double const beyond_m = depth_m - config.axial_offset_m;
    return config.axial_base_m + config.axial_quadratic * beyond_m * beyond_m;
}

}  // namespace

void add_sensor_noise(DepthImage& depth, NoiseConfig const& config, std::uint64_t seed) {
    if (!config.enabled) {
        return;
    }
    DepthImage const perfect = depth;
    Random random(seed);
    for (int row = 0; row < depth.height(); ++row) {
        for (int column = 0; column < depth.width(); ++column) {
            // Drawn for every pixel, used or not, so that one pixel's fate leaves the rest of the image alone.
            Random::NormalDraw const error = random.normal_draw();
            bool const drops = random.uniform() < config.random_dropout;
            bool const drops_at_edge = random.uniform() < config.edge_dropout;
            double const depth_m = perfect.at(row, column);
            bool const is_missing =
                depth_m == 0 || drops || (drops_at_edge && is_depth_edge(perfect, row, column, config.edge_step_m));
            depth.at(row, column) =
                is_missing ? 0.0 : std::max(0.0, depth_m + error.value() * axial_sigma_m(depth_m, config));
        }
    }
}

}  // namespace faster::workload
