#include "faster/workload/observed_edges.hpp"

#include "faster/data/square_sums.hpp"

namespace faster::workload {

Image<std::uint8_t> observed_edges(DepthImage const& depth, Camera const& camera, ObservedEdgesConfig const& config) {
    Image<std::uint8_t> edges(depth.height(), depth.width());
    auto const point_at = [&](int row, int col) {
        double const z = depth.at(row, col);
        double const y_per_z = (row - camera.cy) / camera.fy;
        return z > 0 ? PointSum{(col - camera.cx) / camera.fx * z, y_per_z * z, z, 1} : PointSum();
    };
    for_each_square(depth.height(), depth.width(), config.neighbourhood / 2, point_at,
                    [&](int row, int col, PointSum const& point, PointSum const& square) {
                        edges.at(row, col) = is_edge(point, square, config.threshold) ? 1 : 0;
                    });
    return edges;
}

}  // namespace faster::workload
