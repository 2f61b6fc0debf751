#pragma once
#include <optional>
#include <vector>

#include "faster/config/estimator_config.hpp"
#include "faster/data/stimulus.hpp"
#include "poses/estimation/particle.hpp"

namespace faster::estimation {

/// Where an instance of the object is, as annotated.
struct TruePose {
    Pose pose;
    std::optional<double> visible_share;  ///< of its silhouette, 0..1, if that is known
};

/// What an estimate is made from.
struct Scene {
    Stimulus observed;  ///< mesh, camera, depth and edges; its samples change from iteration to iteration
    ObjectSize size;
    /// Of the mesh's own frame, in which poses are told, in that of `observed`, whose origin is the object's middle:
    /// the accelerator's window has the origin in its middle.
    Eigen::Vector3d own_origin = Eigen::Vector3d::Zero();
    /// Where the first stage found the object; empty: nowhere, so it is looked for in the whole image.
    std::vector<DetectionConfig> boxes;
    /// Of the instances that are to be found, in the frame of `observed`; empty: not known.
    std::vector<TruePose> truths;
    /// By which distances from the truth are told, in the frame of `observed`; empty: the vertices of its mesh, which
    /// is a simplified one.
    std::vector<Eigen::Vector3d> judged_points;

    /// A pose of the frame of `observed` as one of the mesh's own frame, and back.
    Pose own(Pose pose) const;
    Pose centred(Pose pose) const;
};

/// Moves the mesh so that the middle of its box is the origin, and sets size and own_origin.
void centre_mesh(Scene& scene);

/// The box around an object's points in the image, as far as it lies in it; of no width if none of it does, or if
/// some point is nearer than 0.1 m.
DetectionConfig box_around(std::vector<Eigen::Vector3d> const& points, Pose const& pose, Camera const& camera);

/// The box of drawn, not hidden pixels that a sample's counters tell, in the image; of no width if there are none.
DetectionConfig visible_box(SampleCounters const& counters, SampleInput const& sample, int window);

/// Area that two boxes have in common, as a share of what they cover together; 0 if they cover nothing.
double overlap_share(DetectionConfig const& a, DetectionConfig const& b);

/// Area that two boxes have in common, as a share of what `a` covers; 0 if it covers nothing.
double share_inside(DetectionConfig const& a, DetectionConfig const& b);

/// Whether some pixel of the image lies in the box.
bool overlaps(DetectionConfig const& box, int width, int height);

/// How many pixels of the box have a reading.
std::size_t readings_in(DetectionConfig const& box, Image<std::uint16_t> const& depth);

}  // namespace faster::estimation
