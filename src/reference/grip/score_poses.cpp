#include "reference/grip/score_poses.hpp"

#include "kernel/base/on_threads.hpp"

namespace faster::grip {

namespace {

/// All that the poses have in common.
class Scene {
  public:
    Scene(Stimulus const& stimulus, Settings const& settings)
        : camera_(stimulus.posed.camera),
          settings_(settings),
          points_(surface_points(stimulus.posed.mesh, half_pixel_spacing(stimulus.posed))),
          background_(background_cloud(camera_, settings.background)) {
        observed_.points = observed_cloud(stimulus);
        observed_.features = features(observed_.points, Curvature(settings.neighbourhood, nullptr), settings.threshold);
    }

    PoseScore score(Pose const& pose) const {
        FeatureCloud rendered;
        rendered.points = render(points_, pose, camera_);
        rendered.features =
            features(rendered.points, Curvature(settings_.neighbourhood, &background_), settings_.threshold);
        return grip::score(rendered, observed_, settings_.inlier_distance);
    }

  private:
    Camera camera_;
    Settings settings_;
    std::vector<Eigen::Vector3d> points_;
    PointCloud background_;
    FeatureCloud observed_;
};

}  // namespace

std::vector<PoseScore> score_poses(Stimulus const& stimulus, Settings const& settings, unsigned jobs) {
    Scene const scene(stimulus, settings);
    std::vector<Pose> const& poses = stimulus.posed.poses;
    std::vector<PoseScore> scores(poses.size());
    on_threads(poses.size(), jobs, [&](std::size_t i) { scores[i] = scene.score(poses[i]); });
    return scores;
}

}  // namespace faster::grip
