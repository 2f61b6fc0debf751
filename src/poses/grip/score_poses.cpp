#include "poses/grip/score_poses.hpp"

#include "dataflow/base/on_threads.hpp"
#include "faster/dataflow_names.hpp"
#include "poses/grip/rendered_object.hpp"

namespace faster::grip {

PoseScorer::PoseScorer(Stimulus const& stimulus, Settings const& settings) : stimulus_(stimulus), settings_(settings) {
    observed_.points = observed_cloud(stimulus);
    observed_.features = features(observed_.points, settings.neighbourhood, settings.threshold);
}

PoseScore PoseScorer::score(Pose const& pose, PixelArea const& box) const {
    Camera const& camera = stimulus_.posed.camera;
    RenderedObject const object = render(stimulus_.posed.mesh, pose, camera);
    Image<Feature> const of_object =
        features(object, camera, settings_.neighbourhood, settings_.threshold, settings_.background);
    PoseScore score;
    for (int row = 0; row < of_object.height(); ++row)
        for (int col = 0; col < of_object.width(); ++col) {
            Feature const feature = of_object.at(row, col);
            if (feature == Feature::none)
                continue;
            int const image_row = row + object.first_row, image_col = col + object.first_col;
            Eigen::Vector3d const point = back_projected(camera, image_row, image_col, object.depth.at(row, col));
            score.count(feature, point, observed_.features.at(image_row, image_col),
                        observed_.points.at(image_row, image_col), settings_.inlier_distance,
                        box.contains(image_row, image_col));
        }
    return score;
}

std::vector<PoseScore> score_poses(Stimulus const& stimulus, Settings const& settings, unsigned jobs,
                                   TellProgress const& progress) {
    PoseScorer const scorer(stimulus, settings);
    std::vector<Pose> const& poses = stimulus.posed.poses;
    std::vector<PoseScore> scores(poses.size());
    CountedProgress done(poses.size(), progress);
    on_threads(poses.size(), jobs, [&](std::size_t i) {
        scores[i] = scorer.score(poses[i]);
        done.one_more();
    });
    return scores;
}

}  // namespace faster::grip
