#include "poses/nearest_points.hpp"

#include <cmath>
#include <cstddef>
#include <nanoflann.hpp>

namespace faster::poses {
namespace {

/// The points as nanoflann asks for them.
struct Cloud {
    Points const& points;

    std::size_t kdtree_get_point_count() const { return points.size(); }
    double kdtree_get_pt(std::size_t i, std::size_t dimension) const {
        return points[i][static_cast<Eigen::Index>(dimension)];
    }
    template <class Box> bool kdtree_get_bbox(Box& /*box*/) const { return false; }  // it finds out itself
};

using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Cloud>, Cloud, 3>;

double nearest_distance(Tree const& tree, Eigen::Vector3d const& point) {
    std::size_t index = 0;
    double squared_distance = 0;
    nanoflann::KNNResultSet<double> nearest(1);
    nearest.init(&index, &squared_distance);
    tree.findNeighbors(nearest, point.data(), nanoflann::SearchParams());
    return std::sqrt(squared_distance);
}

}  // namespace

double mean_nearest_distance(Points const& from, Points const& to) {
    Cloud const cloud{to};
    Tree const tree(3, cloud);
    double sum = 0;
    for (Eigen::Vector3d const& point : from)
        sum += nearest_distance(tree, point);
    return sum / static_cast<double>(from.size());
}

}  // namespace faster::poses
