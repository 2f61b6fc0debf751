#include "poses/judging/mesh_symmetries.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "dataflow/base/random.hpp"
#include "faster/dataflow_names.hpp"
#include "poses/judging/pose_error.hpp"

namespace faster::poses {
namespace {

constexpr double whole_turn = 2 * portable::pi;
constexpr double most_apart = 0.05;  // diameters

using Triangle = std::array<Eigen::Vector3d, 3>;

Triangle triangle(Mesh const& mesh, std::size_t face) {
    auto const& corners = mesh.faces[face];
    return {mesh.vertices[corners[0]], mesh.vertices[corners[1]], mesh.vertices[corners[2]]};
}

double area_of(Triangle const& corners) { return (corners[1] - corners[0]).cross(corners[2] - corners[0]).norm() / 2; }

/// The middle of a surface: the mean of all its points, not of the few that are drawn.
Eigen::Vector3d middle_of_surface(Mesh const& mesh) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double area = 0;
    for (std::size_t face = 0; face < mesh.faces.size(); ++face) {
        Triangle const corners = triangle(mesh, face);
        double const share = area_of(corners);
        sum += share / 3 * (corners[0] + corners[1] + corners[2]);
        area += share;
    }
    return sum / area;
}

/// The sum of p p^T over all points p of a surface, seen from its middle.
Eigen::Matrix3d spread_about(Eigen::Vector3d const& middle, Mesh const& mesh) {
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (std::size_t face = 0; face < mesh.faces.size(); ++face) {
        Triangle const corners = triangle(mesh, face);
        Eigen::Matrix3d columns;
        columns << corners[0] - middle, corners[1] - middle, corners[2] - middle;
        Eigen::Vector3d const sum = columns.rowwise().sum();
        spread += area_of(corners) / 12 * (columns * columns.transpose() + sum * sum.transpose());
    }
    return spread;
}

/// Points spread over a surface by its area, drawn by a generator of a fixed seed.
Points spread_over(Mesh const& mesh, std::size_t count) {
    std::vector<double> areas;
    double area = 0;
    for (std::size_t face = 0; face < mesh.faces.size(); ++face) {
        area += area_of(triangle(mesh, face));
        areas.push_back(area);
    }
    Random random(1);
    Points points;
    while (area > 0 && points.size() < count) {
        double const place =
            area * (static_cast<double>(points.size()) + random.uniform()) / static_cast<double>(count);
        auto const found = std::lower_bound(areas.begin(), areas.end(), place);
        auto const face = std::min(static_cast<std::size_t>(found - areas.begin()), areas.size() - 1);
        double const root = std::sqrt(random.uniform()), share = random.uniform();
        Triangle const corners = triangle(mesh, face);
        points.push_back((1 - root) * corners[0] + root * (1 - share) * corners[1] + root * share * corners[2]);
    }
    return points;
}

/// A surface about its middle, and whether turns map it to itself.
class TurnedSurface {
  public:
    explicit TurnedSurface(Mesh const& mesh)
        : surface_(spread_over(mesh, 20'000)), middle_(middle_of_surface(mesh)), spread_(spread_about(middle_, mesh)) {
        for (Eigen::Vector3d& point : surface_)
            point -= middle_;
        for (std::size_t i = 0; i < surface_.size(); i += 20)
            some_.push_back(surface_[i]);
        for (Eigen::Vector3d const& vertex : mesh.vertices)
            radius_ = std::max(radius_, (vertex - middle_).norm());
    }

    bool is_empty() const { return surface_.empty(); }
    Eigen::Vector3d const& middle() const { return middle_; }

    /// Longest first; and x, y and z, where they are others.
    std::vector<Eigen::Vector3d> axes() const {
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> const solver(spread_);
        std::vector<Eigen::Vector3d> axes;
        for (Eigen::Index i = 0; i < 3; ++i)
            axes.emplace_back(Eigen::Vector3d::Unit(i));
        for (Eigen::Index i = 2; i >= 0; --i)
            add_if_new(solver.eigenvectors().col(i), axes);
        return axes;
    }

    bool is_mapped_by(Eigen::Matrix3d const& rotation) const {
        Points turned;
        for (Eigen::Vector3d const& point : some_)
            turned.emplace_back(rotation * point);
        return largest_nearest_distance(turned, surface_) <= most_apart * 2 * radius_;
    }

    static void add_if_new(Eigen::Vector3d const& axis, std::vector<Eigen::Vector3d>& axes) {
        constexpr double same = 0.996;  // 5 degrees
        bool const is_old = std::any_of(axes.begin(), axes.end(),
                                        [&](Eigen::Vector3d const& other) { return std::abs(other.dot(axis)) > same; });
        if (!is_old)
            axes.push_back(axis);
    }

  private:
    Points surface_, some_;
    Eigen::Vector3d middle_;
    Eigen::Matrix3d spread_;
    double radius_ = 0;
};

Eigen::Matrix3d turned_about(Eigen::Vector3d const& axis, double share) {
    return Eigen::AngleAxisd(whole_turn * share, axis).toRotationMatrix();
}

class SymmetrySearch {
  public:
    explicit SymmetrySearch(TurnedSurface const& surface) : surface_(surface) {}

    /// Any turn about one of the axes or, if there is none such, some about each.
    void look_about(std::vector<Eigen::Vector3d> const& axes) {
        for (Eigen::Vector3d const& axis : axes) {
            if (is_round(axis))
                round_.push_back(axis);
        }
        for (Eigen::Vector3d const& axis : axes) {
            if (round_.empty())
                look_for_steps(axis);
        }
    }

    /// Half turns about axes across one that has been found. If it is a round one, all others follow from one of them.
    void look_across() {
        std::vector<Eigen::Vector3d> const& axes = round_.empty() ? found_ : round_;
        if (axes.empty())
            return;
        Eigen::Vector3d const side = axes.front().unitOrthogonal();
        int const directions = round_.empty() ? 24 : 1;
        for (int i = 0; i < directions; ++i) {
            Eigen::Matrix3d const turn = turned_about(turned_about(axes.front(), i / (2.0 * directions)) * side, 0.5);
            if (!knows(turn) && surface_.is_mapped_by(turn))
                add(turn);
        }
    }

    std::vector<Eigen::Vector3d> const& round() const { return round_; }
    std::vector<Eigen::Matrix3d> const& turns() const { return turns_; }

  private:
    void look_for_steps(Eigen::Vector3d const& axis) {
        for (int steps = 6; steps > 1; --steps) {
            if (!is_mapped_by_all(axis, steps))
                continue;
            found_.push_back(axis);
            return add(turned_about(axis, 1.0 / steps));
        }
    }

    bool is_round(Eigen::Vector3d const& axis) const { return is_mapped_by_all(axis, 16); }

    /// Equal steps of a whole turn. Those of more than a half are those of less, backwards.
    bool is_mapped_by_all(Eigen::Vector3d const& axis, int steps) const {
        for (int i = 1; i <= steps / 2; ++i) {
            if (!surface_.is_mapped_by(turned_about(axis, i / (1.0 * steps))))
                return false;
        }
        return true;
    }

    bool knows(Eigen::Matrix3d const& turn) const {
        constexpr double same = 0.1;  // in an entry; some 6 degrees
        auto const is_near = [&](Eigen::Matrix3d const& other) { return (other - turn).cwiseAbs().maxCoeff() < same; };
        return is_near(Eigen::Matrix3d::Identity()) || std::any_of(turns_.begin(), turns_.end(), is_near);
    }

    /// With all that follow from it and those that are known.
    void add(Eigen::Matrix3d const& turn) {
        constexpr std::size_t most = 60;
        if (knows(turn) || turns_.size() >= most)
            return;
        turns_.push_back(turn);
        for (std::size_t i = 0; i < turns_.size(); ++i) {
            Eigen::Matrix3d const before = turns_[i] * turn, after = turn * turns_[i];
            add(before);
            add(after);
        }
    }

    TurnedSurface const& surface_;
    std::vector<Eigen::Vector3d> round_, found_;
    std::vector<Eigen::Matrix3d> turns_;
};

}  // namespace

bop::ObjectModel with_symmetries_of_mesh(bop::ObjectModel model, Mesh const& mesh) {
    TurnedSurface const surface(mesh);
    if (surface.is_empty())
        return model;
    SymmetrySearch search(surface);
    search.look_about(surface.axes());
    search.look_across();
    for (Eigen::Vector3d const& axis : search.round())
        model.axes.push_back({axis, surface.middle()});
    for (Eigen::Matrix3d const& turn : search.turns())
        model.symmetries.push_back({turn, surface.middle() - turn * surface.middle()});
    return model;
}

}  // namespace faster::poses
