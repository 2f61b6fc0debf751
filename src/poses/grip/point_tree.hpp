#pragma once
#include <Eigen/Core>
#include <nanoflann.hpp>
#include <vector>

namespace faster::grip {

/// Finds the nearest of some points, of which it keeps a reference.
class PointTree {
  public:
    struct Nearest {
        std::size_t index = 0;
        double squared_distance = 0;
    };

    explicit PointTree(std::vector<Eigen::Vector3d> const& points) : cloud_{points}, tree_(3, cloud_) {
        tree_.buildIndex();
    }
    PointTree(PointTree const&) = delete;
    PointTree& operator=(PointTree const&) = delete;

    /// The first point, at the largest distance that a double has, if all are beyond that.
    Nearest nearest(Eigen::Vector3d const& place) const {
        Nearest found;
        nanoflann::KNNResultSet<double> result(1);
        result.init(&found.index, &found.squared_distance);
        tree_.findNeighbors(result, place.data(), nanoflann::SearchParams());
        return found;
    }

  private:
    /// The points as nanoflann asks for them.
    struct Cloud {
        std::vector<Eigen::Vector3d> const& points;

        std::size_t kdtree_get_point_count() const { return points.size(); }
        double kdtree_get_pt(std::size_t index, std::size_t axis) const {
            return points[index](static_cast<Eigen::Index>(axis));
        }
        template <class Box> bool kdtree_get_bbox(Box& /*box*/) const { return false; }  // it finds out itself
    };

    Cloud cloud_;
    nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Cloud>, Cloud, 3> tree_;
};

}  // namespace faster::grip
