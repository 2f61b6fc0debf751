#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "dataflow/run/config/load_config.hpp"
#include "faster/dataflow_names.hpp"
#include "poses/bop/detections.hpp"
#include "poses/estimation/scene.hpp"
#include "poses/judging/counted_poses.hpp"

namespace faster {

/// An object in an image of a dataset in the format of BOP.
struct BopRequest {
    std::string folder;      ///< empty: none
    std::string detections;  ///< JSON file; empty: the annotated boxes
    std::string split;       ///< folder of the scenes; empty: as read_dataset() has it
    std::string models_in;   ///< unit of the meshes, m or mm; empty: as the dataset's kind has it
    std::optional<int> scene_id;
    std::optional<int> im_id;
    std::optional<int> obj_id;

    bop::ImageId image() const { return {scene_id.value_or(0), im_id.value_or(0)}; }
    int object() const { return obj_id.value_or(0); }
};

/// Throws InputError for what no estimate goes by: a trace, which has no mesh to move, a table of poses, no samples.
void require_estimable(LoadedConfig const& loaded);

/// A line for each key of the command line, or of an experiment's methods, that a dataset has instead: what is looked
/// for and where, the camera, the scene, the meshes.
std::vector<std::string> idle_keys_of_datasets(LoadedConfig const& loaded);

/// The scene of an image: the truths are the object's most visible annotated poses in it, as many as the targets ask
/// for. Boxes: all detections of the object in the image or, without detections, the truths' that are not hidden, with
/// the confidence of `estimator.box.confidence`; an object that nobody detected, or that is hidden, has none. Says what
/// looks like a mistake of the dataset's. Throws InputError for what the dataset does not have.
estimation::Scene bop_scene(LoadedConfig const& loaded, BopRequest const& request);

/// The scene of a target of a dataset at hand, of a configuration that is require_estimable(), and `boxes`, whose
/// confidences are their scores.
estimation::Scene dataset_scene(LoadedConfig const& loaded, bop::Dataset const& dataset, bop::Target const& target,
                                std::vector<bop::Detection> const& boxes);

/// Metres per unit that is called m or mm; nothing for an empty name.
std::optional<double> unit_of_models(std::string const& name);

/// The dataset of a request.
bop::Dataset dataset_of(BopRequest const& request);

/// The annotated boxes of objects in an image, but for hidden ones: of what is visible, or of all of it, or else what
/// the pose says. `camera`: of the image; `mesh`: of an object.
std::vector<bop::Detection> annotated_boxes(poses::Truths const& objects, bop::ImageId image, Camera const& camera,
                                            std::function<Mesh const&(int obj_id)> const& mesh, double confidence);

/// Whether some pixel of a camera's image lies in a box.
bool overlaps(bop::ImageBox const& box, Camera const& camera);

/// The scene of a configuration: its workload without samples, whose pose is the truth (of a depth image only if it is
/// configured), and the box of `estimator.box.*`. Throws InputError for a configuration that no estimate goes by, and a
/// box outside the image.
estimation::Scene configured_scene(LoadedConfig const& loaded);

}  // namespace faster
