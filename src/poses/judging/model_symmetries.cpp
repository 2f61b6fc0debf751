#include "poses/judging/model_symmetries.hpp"

#include <Eigen/Geometry>

#include "dataflow/base/portable_math.hpp"
#include "faster/dataflow_names.hpp"

namespace faster::poses {

namespace {

constexpr int steps_per_turn = 315;  // ceil(pi / 0.01)

/// The i-th turn about an axis.
Pose turn(bop::ObjectModel::Axis const& axis, int i) {
    Pose pose;
    pose.rotation = Eigen::AngleAxisd(i * (2 * portable::pi / steps_per_turn), axis.direction).toRotationMatrix();
    pose.translation = axis.offset - pose.rotation * axis.offset;
    return pose;
}

/// The identity, and every turn about every axis.
std::vector<Pose> turns_of(bop::ObjectModel const& model) {
    std::vector<Pose> turns{Pose{}};
    for (bop::ObjectModel::Axis const& axis : model.axes) {
        for (int i = 1; i < steps_per_turn; ++i)
            turns.push_back(turn(axis, i));
    }
    return turns;
}

}  // namespace

std::vector<Pose> symmetries_of(bop::ObjectModel const& model) {
    std::vector<Pose> discrete{Pose{}};
    discrete.insert(discrete.end(), model.symmetries.begin(), model.symmetries.end());
    std::vector<Pose> const turns = turns_of(model);
    std::vector<Pose> all;
    for (Pose const& symmetry : discrete) {
        for (Pose const& then : turns)
            all.push_back({then.rotation * symmetry.rotation, then.rotation * symmetry.translation + then.translation});
    }
    return all;
}

}  // namespace faster::poses
