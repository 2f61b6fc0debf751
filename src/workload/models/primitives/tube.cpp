#include "workload/models/primitives/tube.hpp"

#include <Eigen/Geometry>

namespace faster::models {
namespace {

/// Direction of the way at station i: from its predecessor to its successor.
Eigen::Vector3d direction(std::vector<Station> const& stations, std::size_t i, Ends ends) {
    std::size_t const last = stations.size() - 1;
    bool const joined = ends == Ends::joined;
    std::size_t const before = i > 0 ? i - 1 : (joined ? last : 0);
    std::size_t const after = i < last ? i + 1 : (joined ? 0 : last);
    return (stations[after].centre - stations[before].centre).normalized();
}

}  // namespace

Mesh tube(std::vector<Station> const& stations, Eigen::Vector3d const& up, double edge_length, Between between,
          Ends ends) {
    std::vector<Section> sections;
    for (std::size_t i = 0; i < stations.size(); ++i) {
        Station const& station = stations[i];
        Eigen::Vector3d const forward = direction(stations, i, ends);
        Eigen::Vector3d const sideways = up.cross(forward).normalized();
        sections.push_back({station.centre, station.half_width * sideways,
                            station.half_height * forward.cross(sideways), station.exponent});
    }
    return skin(sections, edge_length, between, ends);
}

}  // namespace faster::models
