#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "dataflow/base/counted_progress.hpp"
#include "faster/config/edge_map_config.hpp"
#include "faster/data/image.hpp"
#include "faster/data/mesh.hpp"
#include "faster/dataflow_names.hpp"
#include "poses/quality/contour_quality.hpp"

namespace faster::quality {

/// Sums of the qualities of many edge maps.
struct QualitySums {
    std::size_t poses = 0;
    double precision = 0;
    double recall = 0;
    double thickness = 0;
    std::size_t closed = 0;
    std::size_t thin = 0;
    std::size_t closed_and_thin = 0;

    void add(ContourQuality const& quality) {
        poses += 1;
        precision += quality.precision;
        recall += quality.recall;
        thickness += quality.thickness;
        closed += quality.is_closed ? 1 : 0;
        thin += quality.is_thin ? 1 : 0;
        closed_and_thin += quality.is_closed && quality.is_thin ? 1 : 0;
    }

    void include(QualitySums const& other) {
        poses += other.poses;
        precision += other.precision;
        recall += other.recall;
        thickness += other.thickness;
        closed += other.closed;
        thin += other.thin;
        closed_and_thin += other.closed_and_thin;
    }

    /// Of one of the sums; 0 without poses.
    double mean(double sum) const { return poses > 0 ? sum / static_cast<double>(poses) : 0; }
    double share(std::size_t count) const { return mean(static_cast<double>(count)); }
};

/// A pose's edge map by an algorithm, to be looked at.
struct Specimen {
    ContourQuality quality;
    Image<std::uint8_t> edge_map;  ///< all three 0 or 1, W x W
    Image<std::uint8_t> silhouette;
    Image<std::uint8_t> contour;
};

/// What one algorithm did with many poses of one object: sums of their qualities, and two poses by F1.
struct PoseSurvey : QualitySums {
    EdgeMapAlgorithm algorithm = EdgeMapAlgorithm::dual_map;
    std::string object;
    Specimen best;
    Specimen worst;
};

/// `count` poses of an object, turned at random (equally likely in all directions) and near the image's centre, as far
/// away as it takes to fit a window of 200 px. The same for the same seed.
std::vector<Pose> random_poses(Mesh const& mesh, std::size_t count, std::uint64_t seed);

/// The untimed reference's edge maps of all poses, with each of the algorithms, against the silhouettes.
/// `progress`: told of each edge map.
std::vector<PoseSurvey> survey(std::string const& object, Mesh const& mesh, std::vector<Pose> const& poses,
                               std::vector<EdgeMapAlgorithm> const& algorithms, TellProgress const& progress = {});

/// One row per algorithm and object: `algorithm,object,poses,precision,recall,thickness,closed,thin,closed_and_thin`,
/// means and shares over the poses.
std::string survey_csv(std::vector<PoseSurvey> const& rows);

/// A row per algorithm over all objects, every pose counting once, as a Markdown table.
std::string survey_markdown(std::vector<PoseSurvey> const& rows);

}  // namespace faster::quality
