#include "poses/quality/pose_survey.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "dataflow/base/random.hpp"
#include "dataflow/run/config/choice_names.hpp"
#include "faster/data/stimulus.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/reference/scorer.hpp"
#include "faster/reference/vertex_transform.hpp"
#include "poses/quality/silhouette.hpp"

namespace faster::quality {

namespace {

/// One per algorithm, in the order of their first rows.
std::vector<PoseSurvey> totals_of(std::vector<PoseSurvey> const& rows) {
    std::vector<PoseSurvey> totals;
    for (PoseSurvey const& row : rows) {
        auto total = std::find_if(totals.begin(), totals.end(),
                                  [&row](PoseSurvey const& other) { return other.algorithm == row.algorithm; });
        if (total == totals.end()) {
            totals.emplace_back();
            total = totals.end() - 1;
            total->algorithm = row.algorithm;
        }
        total->include(row);
    }
    return totals;
}

constexpr double nearest_m = 0.6;
constexpr double largest_radius_px = 90;  // in a window of 200

double radius_of(Mesh const& mesh) {
    double radius = 0;
    for (Eigen::Vector3d const& vertex : mesh.vertices)
        radius = std::max(radius, vertex.norm());
    return radius;
}

Eigen::Matrix3d random_rotation(Random& random) {
    double const w = random.normal();
    double const x = random.normal();
    double const y = random.normal();
    double const z = random.normal();
    return Eigen::Quaterniond(w, x, y, z).normalized().toRotationMatrix();
}

/// Nothing is observed: only the maps are looked at.
Stimulus stimulus_of(Mesh const& mesh, std::vector<Pose> const& poses) {
    Stimulus stimulus;
    Camera const& camera = stimulus.posed.camera;
    stimulus.posed.mesh = mesh;
    stimulus.posed.poses = poses;
    stimulus.observed_depth = {stimulus.height, stimulus.width};
    stimulus.observed_edges = {stimulus.height, stimulus.width};
    for (Pose const& pose : poses) {
        Eigen::Vector3d const& origin = pose.translation;
        SampleInput sample;
        sample.centre_col = static_cast<std::int32_t>(std::floor(camera.fx * origin.x() / origin.z() + camera.cx));
        sample.centre_row = static_cast<std::int32_t>(std::floor(camera.fy * origin.y() / origin.z() + camera.cy));
        sample.triangle_count = static_cast<std::uint32_t>(mesh.faces.size());
        stimulus.samples.push_back(sample);
    }
    return stimulus;
}

/// Which contour an algorithm is to draw.
ContourSide side_of(EdgeMapAlgorithm algorithm) {
    return contour_is_on_object(algorithm) ? ContourSide::inside : ContourSide::outside;
}

void look_at(Image<std::uint8_t> const& edge_map, Image<std::uint8_t> const& silhouette, PoseSurvey& row) {
    ContourSide const side = side_of(row.algorithm);
    ContourQuality const quality = contour_quality(edge_map, silhouette, side);
    bool const is_first = row.poses == 0;
    row.add(quality);
    Specimen const specimen{quality, edge_map, silhouette, contour_of(silhouette, side)};
    if (is_first || quality.f1() > row.best.quality.f1())
        row.best = specimen;
    if (is_first || quality.f1() < row.worst.quality.f1())
        row.worst = specimen;
}

}  // namespace

std::string survey_csv(std::vector<PoseSurvey> const& rows) {
    std::string text = "algorithm,object,poses,precision,recall,thickness,closed,thin,closed_and_thin\n";
    for (PoseSurvey const& row : rows)
        text +=
            fmt::format("{},{},{},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f}\n", choice_name(row.algorithm), row.object,
                        row.poses, row.mean(row.precision), row.mean(row.recall), row.mean(row.thickness),
                        row.share(row.closed), row.share(row.thin), row.share(row.closed_and_thin));
    return text;
}

std::string survey_markdown(std::vector<PoseSurvey> const& rows) {
    std::string text =
        "| algorithm | poses | precision | recall | thickness [px] | closed | thin | closed and thin |\n"
        "| --- | --- | --- | --- | --- | --- | --- | --- |\n";
    for (PoseSurvey const& row : totals_of(rows))
        text += fmt::format("| {} | {} | {:.1f} % | {:.1f} % | {:.2f} | {:.1f} % | {:.1f} % | {:.1f} % |\n",
                            choice_name(row.algorithm), row.poses, 100 * row.mean(row.precision),
                            100 * row.mean(row.recall), row.mean(row.thickness), 100 * row.share(row.closed),
                            100 * row.share(row.thin), 100 * row.share(row.closed_and_thin));
    return text;
}

std::vector<Pose> random_poses(Mesh const& mesh, std::size_t count, std::uint64_t seed) {
    Random random(seed);
    Camera const camera;
    double const distance = std::max(nearest_m, camera.fx * radius_of(mesh) / largest_radius_px);
    std::vector<Pose> poses(count);
    for (Pose& pose : poses) {
        pose.rotation = random_rotation(random);
        double const right_px = 100 * (random.uniform() - 0.5);
        double const down_px = 100 * (random.uniform() - 0.5);
        pose.translation = {right_px * distance / camera.fx, down_px * distance / camera.fy, distance};
    }
    return poses;
}

std::vector<PoseSurvey> survey(std::string const& object, Mesh const& mesh, std::vector<Pose> const& poses,
                               std::vector<EdgeMapAlgorithm> const& algorithms, TellProgress const& progress) {
    Stimulus const stimulus = stimulus_of(mesh, poses);
    reference::VertexTransform transform(mesh, stimulus.posed.camera, stimulus.fraction);
    std::vector<Image<std::uint8_t>> silhouettes;
    for (std::size_t i = 0; i < poses.size(); ++i)
        silhouettes.push_back(silhouette(transform(poses[i]), stimulus, stimulus.samples[i]));
    std::vector<PoseSurvey> rows;
    CountedProgress done(algorithms.size() * poses.size(), progress);
    for (EdgeMapAlgorithm const algorithm : algorithms) {
        EdgeMapConfig config;
        config.algorithm = algorithm;
        reference::Scorer scorer(stimulus, config);
        PoseSurvey row;
        row.algorithm = algorithm;
        row.object = object;
        for (std::size_t i = 0; i < poses.size(); ++i) {
            scorer.run(i);
            look_at(scorer.maps().edge_map, silhouettes[i], row);
            done.one_more();
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

}  // namespace faster::quality
