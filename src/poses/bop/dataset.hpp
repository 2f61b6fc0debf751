#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "faster/data/camera.hpp"
#include "faster/data/mesh.hpp"

namespace faster::bop {

/// A box in an image [px], as BOP and COCO have it: the left upper corner and the size. May lie partly outside.
struct ImageBox {
    double left = 0;
    double top = 0;
    double width = 0;
    double height = 0;
};

/// An object in an image, as annotated (scene_gt.json, scene_gt_info.json).
struct GroundTruth {
    int obj_id = 0;
    Pose pose;                            ///< model to camera [m]
    std::optional<ImageBox> box;          ///< of the whole silhouette, as if nothing hid it
    std::optional<ImageBox> visible_box;  ///< of what is to be seen of it
    std::optional<double> visible_share;  ///< of the silhouette's pixels, 0..1
};

/// Scene and image, the name of an image in all files of BOP.
struct ImageId {
    int scene_id = 0;
    int im_id = 0;

    friend bool operator<(ImageId const& a, ImageId const& b) {
        return std::pair(a.scene_id, a.im_id) < std::pair(b.scene_id, b.im_id);
    }
    friend bool operator==(ImageId const& a, ImageId const& b) {
        return std::pair(a.scene_id, a.im_id) == std::pair(b.scene_id, b.im_id);
    }
};

struct DatasetImage {
    ImageId id;
    Camera camera;            ///< width and height are 0 if the dataset does not say: load_observation() does
    double depth_unit_m = 0;  ///< metres per count of the depth image
    std::filesystem::path depth;
    std::vector<GroundTruth> objects;
};

/// An object of a dataset: where its mesh is, and what models_info.json says of it.
struct ObjectModel {
    int obj_id = 0;
    std::string name;  ///< of its file, without extension: obj_000005, or 005_tomato_soup_can
    std::filesystem::path mesh;
    double unit_m = 1;                 ///< metres per unit of the mesh file
    std::optional<double> diameter_m;  ///< largest distance between two of its points
    struct Axis {
        Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  ///< of length 1
        Eigen::Vector3d offset = Eigen::Vector3d::Zero();      ///< a point on it [m]
    };
    std::vector<Pose> symmetries;  ///< that turn the model into itself [m], beside the identity
    std::vector<Axis> axes;        ///< about which it may be turned by any angle
};

/// How many instances of an object are to be found in an image (test_targets_bop19.json).
struct Target {
    ImageId image;
    int obj_id = 0;
    int inst_count = 1;
};

struct Dataset {
    std::filesystem::path folder;
    std::vector<DatasetImage> images;   ///< by scene and image
    std::map<int, ObjectModel> models;  ///< by obj_id
    std::vector<Target> targets;        ///< of the file or, without one, every object of every image; by image, object

    DatasetImage const* find(ImageId id) const;  ///< null if there is none
};

}  // namespace faster::bop
