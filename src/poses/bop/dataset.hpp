#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "dataflow/base/input_error.hpp"
#include "faster/data/camera.hpp"
#include "faster/data/mesh.hpp"
#include "faster/dataflow_names.hpp"

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
    std::optional<ImageBox> box;          ///< of the whole silhouette, as if nothing hid it; none if it is outside
    std::optional<ImageBox> visible_box;  ///< of what is to be seen of it; none if it is hidden
    std::optional<double> visible_share;  ///< of the silhouette's pixels, 0..1
    std::string problem = {};             ///< what is wrong with it in the file, see sound()

    bool is_hidden() const { return visible_share.value_or(1) <= 0; }
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
    Camera camera;            ///< width and height may be 0 or others than the image's: load_observation() knows
    bool has_size = false;    ///< the dataset says of this very image how large it is
    double depth_unit_m = 0;  ///< metres per count of the depth image
    std::filesystem::path depth;
    std::vector<GroundTruth> objects;
    std::string problem = {};  ///< what is wrong with its camera in the file, see sound()
};

/// An object of a dataset: where its mesh is, and what models_info.json says of it.
struct ObjectModel {
    int obj_id = 0;
    std::string name;  ///< of its file, without extension: obj_000005, or 005_tomato_soup_can
    std::filesystem::path mesh;
    std::filesystem::path judged_mesh;  ///< with which poses are judged; empty: the same
    double unit_m = 1;                  ///< metres per unit of the mesh file
    std::optional<double> diameter_m;   ///< largest distance between two of its points
    struct Axis {
        Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  ///< of length 1
        Eigen::Vector3d offset = Eigen::Vector3d::Zero();      ///< a point on it [m]
    };
    std::vector<Pose> symmetries;  ///< that turn the model into itself [m], beside the identity
    std::vector<Axis> axes;        ///< about which it may be turned by any angle
    struct Bounds {
        Eigen::Vector3d min = Eigen::Vector3d::Zero();   ///< [m]
        Eigen::Vector3d size = Eigen::Vector3d::Zero();  ///< [m]
    };
    std::optional<Bounds> bounds;  ///< as models_info.json has them
    std::filesystem::path info;    ///< that file; empty if there is none
    std::string problem = {};      ///< what is wrong with it there, see sound()
};

/// The item itself. Files of a dataset are read whole, but what is wrong with an item is nobody's business who does not
/// ask for it: throws the InputError that was kept when it was read.
template <class Item> Item const& sound(Item const& item) {
    if (!item.problem.empty())
        throw InputError(item.problem);
    return item;
}

/// Keeps what is wrong with an item, of several the first, for those who ask for it.
template <class Item, class Read> void read_into(Item& item, Read const& read) {
    try {
        read();
    } catch (InputError const& error) {
        item.problem = item.problem.empty() ? error.what() : item.problem;
    }
}

/// How many instances of an object are to be found in an image (test_targets_bop19.json, test_targets_bop24.json).
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
    std::filesystem::path targets_file = {};       ///< empty: there is none
    std::vector<std::string> warnings;             ///< what was mended on reading, and what looks like a mistake
    std::vector<std::string> warnings_of_targets;  ///< for those who take them all

    DatasetImage const* find(ImageId id) const;  ///< null if there is none
    std::string place_of_targets() const;        ///< for messages: what names the objects that are to be found
};

}  // namespace faster::bop
