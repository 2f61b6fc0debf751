#include "poses/experiments/made_dataset.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <mutex>

#include "dataflow/base/counter_random.hpp"
#include "dataflow/base/files/atomic_folder.hpp"
#include "dataflow/base/files/text_file.hpp"
#include "dataflow/base/fnv1a.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/base/json.hpp"
#include "dataflow/base/on_threads.hpp"
#include "dataflow/base/portable_math.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/workload/files/mesh_file.hpp"
#include "faster/workload/files/png_image.hpp"
#include "faster/workload/scene_renderer.hpp"
#include "faster/workload/sensor_noise.hpp"
#include "poses/bop/write_dataset.hpp"
#include "poses/experiments/ycb_classes.hpp"
#include "poses/judging/mesh_symmetries.hpp"

namespace faster::experiments {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr int most_tries = 2000;
constexpr double near_enough = 0.03;
constexpr int coarse = 4;               ///< tries look at every fourth pixel
constexpr double half_spread_m = 0.16;  ///< of the objects on the table
constexpr double apart = 0.6;           ///< of the radii of two objects: corners may touch

double between(double low, double high, CounterRandom& random) { return low + (high - low) * random.uniform(); }

/// The table as the camera sees it: y of its frame is the normal, which points up.
struct Table {
    Matrix3d rotation;
    Vector3d middle;
    workload::Plane plane() const { return {middle, rotation.col(1)}; }
};

Table drawn_table(CounterRandom& random) {
    double const tilt = between(20, 50, random) * portable::pi / 180;
    Table table;
    // Up is against the camera's y, and towards it the more the steeper it looks down.
    Vector3d const up(0, -std::cos(tilt), -std::sin(tilt));
    Vector3d const right = Vector3d::UnitX();
    table.rotation << right, up, right.cross(up);
    table.middle = {0, 0, between(0.65, 0.85, random)};
    return table;
}

struct Placed {
    int obj_id = 0;
    Pose pose;
    Vector3d foot;      ///< on the table, in its frame
    double radius = 0;  ///< of what it covers
};

/// One of the six sides down, and then any turn about the table's normal.
Matrix3d drawn_rotation(CounterRandom& random) {
    std::uint32_t const side = random.below(6);
    Matrix3d lying = Matrix3d::Identity();
    if (side / 2 == 0)
        lying = Eigen::AngleAxisd(portable::pi / 2, Vector3d::UnitX()).toRotationMatrix();
    else if (side / 2 == 1)
        lying = Eigen::AngleAxisd(portable::pi / 2, Vector3d::UnitZ()).toRotationMatrix();
    if (side % 2 == 1)
        lying = Eigen::AngleAxisd(portable::pi, Vector3d::UnitX()).toRotationMatrix() * lying;
    return Eigen::AngleAxisd(between(0, 2 * portable::pi, random), Vector3d::UnitY()).toRotationMatrix() * lying;
}

Placed placed(int obj_id, Mesh const& mesh, Table const& table, double spread, CounterRandom& random) {
    Placed object;
    object.obj_id = obj_id;
    Matrix3d const on_table = drawn_rotation(random);
    double lowest = std::numeric_limits<double>::infinity();
    for (Vector3d const& vertex : mesh.vertices) {
        Vector3d const p = on_table * vertex;
        lowest = std::min(lowest, p.y());
        object.radius = std::max(object.radius, std::hypot(p.x(), p.z()));
    }
    double const x = between(-spread, spread, random);
    object.foot = {x, 0, between(-spread, spread, random)};
    object.pose.rotation = table.rotation * on_table;
    object.pose.translation = table.middle + table.rotation * (object.foot - Vector3d(0, lowest, 0));
    return object;
}

bool has_room(Placed const& object, std::vector<Placed> const& others) {
    return std::all_of(others.begin(), others.end(), [&](Placed const& other) {
        return (object.foot - other.foot).norm() > apart * (object.radius + other.radius);
    });
}

struct Layout {
    Table table;
    std::vector<Placed> objects;
};

Layout drawn_layout(int wanted, std::map<int, Mesh> const& meshes, CounterRandom& random) {
    constexpr int tries_for_a_place = 20;
    Layout layout;
    layout.table = drawn_table(random);
    std::size_t const count = 5 + random.below(3);
    layout.objects.push_back(placed(wanted, meshes.at(wanted), layout.table, half_spread_m / 2, random));
    std::vector<int> others;
    for (auto const& [id, mesh] : meshes)
        if (id != wanted)
            others.push_back(id);
    while (layout.objects.size() < count && !others.empty()) {
        auto const which = others.begin() + random.below(static_cast<std::uint32_t>(others.size()));
        for (int i = 0; i < tries_for_a_place; ++i) {
            Placed const object = placed(*which, meshes.at(*which), layout.table, half_spread_m, random);
            if (!has_room(object, layout.objects))
                continue;
            layout.objects.push_back(object);
            break;
        }
        others.erase(which);
    }
    return layout;
}

workload::DepthImage alone(Placed const& object, std::map<int, Mesh> const& meshes, Camera const& camera) {
    workload::DepthImage depth(camera.height, camera.width);
    workload::draw_mesh(meshes.at(object.obj_id), object.pose, camera, depth);
    return depth;
}

workload::DepthImage all_of(Layout const& layout, std::map<int, Mesh> const& meshes, Camera const& camera) {
    workload::DepthImage depth(camera.height, camera.width);
    for (Placed const& object : layout.objects)
        workload::draw_mesh(meshes.at(object.obj_id), object.pose, camera, depth);
    workload::draw_plane(layout.table.plane(), camera, depth);
    return depth;
}

/// Pixels of an object, and the box around them.
class Silhouette {
  public:
    void add(int row, int column) {
        ++pixels_;
        top_ = std::min(top_, row);
        bottom_ = std::max(bottom_, row);
        left_ = std::min(left_, column);
        right_ = std::max(right_, column);
    }
    std::size_t pixels() const { return pixels_; }
    bool touches_border(Camera const& camera) const {
        return pixels_ > 0 && (top_ == 0 || left_ == 0 || bottom_ + 1 == camera.height || right_ + 1 == camera.width);
    }
    bop::ImageBox box() const {
        if (pixels_ == 0)
            return {};
        return {1.0 * left_, 1.0 * top_, 1.0 + right_ - left_, 1.0 + bottom_ - top_};
    }

  private:
    std::size_t pixels_ = 0;
    int top_ = std::numeric_limits<int>::max(), left_ = top_, bottom_ = -1, right_ = -1;
};

struct Seen {
    Silhouette whole;
    Silhouette visible;
    double share() const {
        return whole.pixels() == 0 ? 0 : static_cast<double>(visible.pixels()) / static_cast<double>(whole.pixels());
    }
};

Seen seen(workload::DepthImage const& object, workload::DepthImage const& scene) {
    Seen result;
    for (int row = 0; row < object.height(); ++row)
        for (int column = 0; column < object.width(); ++column) {
            if (object.at(row, column) == 0)
                continue;
            result.whole.add(row, column);
            if (object.at(row, column) <= scene.at(row, column))
                result.visible.add(row, column);
        }
    return result;
}

/// How far a layout is from what is wanted; more than 1 if it is of no use.
double distance(Layout const& layout, double visible, std::map<int, Mesh> const& meshes, Camera const& camera) {
    Placed const& wanted = layout.objects.front();
    Seen const object = seen(alone(wanted, meshes, camera), all_of(layout, meshes, camera));
    constexpr std::size_t least_pixels = 20;
    if (object.whole.touches_border(camera) || object.visible.pixels() < least_pixels)
        return 2;
    return std::abs(object.share() - visible);
}

bop::GroundTruth annotation(Placed const& object, Seen const& pixels) {
    bop::GroundTruth truth;
    truth.obj_id = object.obj_id;
    truth.pose = object.pose;
    truth.box = pixels.whole.box();
    truth.visible_box = pixels.visible.box();
    truth.visible_share = pixels.share();
    return truth;
}

namespace fs = std::filesystem;

constexpr char const* recipe_file = "scenes.json";

std::string hash_of(std::map<int, Mesh> const& meshes) {
    Fnv1a hash;
    for (auto const& [id, mesh] : meshes)
        hash.add(std::to_string(id) + files::mesh_bytes(mesh));
    return std::to_string(hash.value());
}

/// What the images depend on; of another version of the generator as well.
std::string recipe_of(Setting const& setting, std::map<int, Mesh> const& meshes, std::uint64_t seed) {
    Json recipe{{"format", "faster-scenes"},
                {"version", 1},
                {"seed", seed},
                {"objects", setting.objects},
                {"images", setting.images},
                {"visible", setting.visible}};
    if (!setting.models.empty())
        recipe["models"] = hash_of(meshes);
    return recipe.dump(1) + "\n";
}

bool holds(fs::path const& folder, std::string const& recipe) {
    return fs::exists(folder / recipe_file) && io::read_file(folder / recipe_file) == recipe;
}

class DatasetMaker {
  public:
    DatasetMaker(fs::path folder, Setting const& setting, std::map<int, Mesh> meshes, std::uint64_t seed)
        : folder_(std::move(folder)), setting_(setting), seed_(seed), meshes_(std::move(meshes)) {}

    void make(std::size_t jobs, std::function<void(std::size_t, std::size_t)> const& progress) {
        make_folders();
        write_models();
        make_images(jobs, progress);
        for (std::string const& name : setting_.objects)
            write_scene(obj_id_of(name));
        write_camera_and_targets();
    }

    std::size_t missed() const { return missed_; }

  private:
    fs::path scene_folder(int scene_id) const { return folder_ / "test" / fmt::format("{:06}", scene_id); }
    std::size_t per_class() const { return static_cast<std::size_t>(setting_.images); }

    void make_folders() const {
        fs::create_directories(folder_ / "models");
        for (std::string const& name : setting_.objects)
            fs::create_directories(scene_folder(obj_id_of(name)) / "depth");
    }

    void write_models() const {
        for (auto const& [id, mesh] : meshes_)
            io::write_file(folder_ / "models" / fmt::format("obj_{:06}.ply", id), bop::ply_text(mesh));
        io::write_file(folder_ / "models" / "models_info.json", bop::models_info_json(models(), meshes_));
    }
    /// What turns them into themselves is known of the built-in meshes, and looked for in others.
    std::map<int, bop::ObjectModel> models() const {
        std::map<int, bop::ObjectModel> models;
        for (auto const& [id, mesh] : meshes_) {
            models[id].obj_id = id;
            if (setting_.models.empty())
                add_symmetries(models[id], ycb_classes()[static_cast<std::size_t>(id) - 1]);
            else
                models[id] = poses::with_symmetries_of_mesh(models[id], mesh);
        }
        return models;
    }

    void make_images(std::size_t jobs, std::function<void(std::size_t, std::size_t)> const& progress) {
        images_.resize(setting_.objects.size() * per_class());
        std::mutex mutex;
        std::size_t done = 0;
        on_threads(images_.size(), jobs, [&](std::size_t i) {
            bop::ImageId const id{obj_id_of(setting_.objects[i / per_class()]), static_cast<int>(i % per_class())};
            MadeScene scene = made_scene({id.scene_id, setting_.visible, seed_, static_cast<std::uint64_t>(id.im_id)},
                                         meshes_, camera_);
            bool const is_as_wished = scene.is_as_wished;
            images_[i] = written_image(id, std::move(scene));
            std::lock_guard<std::mutex> const lock(mutex);
            missed_ += is_as_wished ? 0U : 1U;
            progress(++done, images_.size());
        });
    }

    bop::DatasetImage written_image(bop::ImageId id, MadeScene scene) const {
        bop::DatasetImage image;
        image.id = id;
        image.camera = camera_;
        image.depth_unit_m = bop::written_depth_unit_m;
        image.objects = std::move(scene.objects);
        files::write_png(scene_folder(id.scene_id) / "depth" / fmt::format("{:06}.png", id.im_id),
                         bop::depth_counts(scene.depth));
        return image;
    }

    void write_scene(int scene_id) const {
        std::vector<bop::DatasetImage> images;
        for (bop::DatasetImage const& image : images_)
            if (image.id.scene_id == scene_id)
                images.push_back(image);
        fs::path const folder = scene_folder(scene_id);
        io::write_file(folder / "scene_camera.json", bop::scene_camera_json(images));
        io::write_file(folder / "scene_gt.json", bop::scene_gt_json(images));
        io::write_file(folder / "scene_gt_info.json", bop::scene_gt_info_json(images));
    }

    void write_camera_and_targets() const {
        Json const camera{{"cx", camera_.cx}, {"cy", camera_.cy},         {"depth_scale", 0.1},    {"fx", camera_.fx},
                          {"fy", camera_.fy}, {"height", camera_.height}, {"width", camera_.width}};
        io::write_file(folder_ / "camera.json", camera.dump(1) + "\n");
        std::vector<bop::Target> targets;
        for (bop::DatasetImage const& image : images_)
            targets.push_back({image.id, image.id.scene_id, 1});
        io::write_file(folder_ / "test_targets_bop19.json", bop::targets_json(targets));
    }

    fs::path folder_;
    Setting const& setting_;
    std::uint64_t seed_;
    Camera camera_;
    std::map<int, Mesh> meshes_;
    std::vector<bop::DatasetImage> images_;
    std::size_t missed_ = 0;
};

}  // namespace

MadeScene made_scene(SceneWish const& wish, std::map<int, Mesh> const& meshes, Camera const& camera) {
    CounterRandom random(wish.seed, wish.number, static_cast<std::uint32_t>(wish.obj_id));
    double const visible = between(wish.visible[0], wish.visible[1], random);
    Camera const small = workload::downscaled(camera, coarse);
    Layout best;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < most_tries && least > near_enough; ++i) {
        Layout const layout = drawn_layout(wish.obj_id, meshes, random);
        double const off = distance(layout, visible, meshes, small);
        if (off < least) {
            least = off;
            best = layout;
        }
    }
    MadeScene scene;
    scene.is_as_wished = least <= near_enough;
    scene.depth = all_of(best, meshes, camera);
    for (Placed const& object : best.objects)
        scene.objects.push_back(annotation(object, seen(alone(object, meshes, camera), scene.depth)));
    workload::add_sensor_noise(scene.depth, {}, random.bits());
    return scene;
}

std::size_t make_dataset(fs::path const& folder, Setting const& setting, std::map<int, Mesh> meshes, std::uint64_t seed,
                         std::size_t jobs, std::function<void(std::size_t, std::size_t)> const& progress) {
    for (std::string const& name : setting.objects)
        if (meshes.count(obj_id_of(name)) == 0)
            throw InputError(setting.models.string() + ": has no mesh of " + name + ", expected one called " + name +
                             ".obj or 001_" + name + ".obj");
    std::string const recipe = recipe_of(setting, meshes, seed);
    if (holds(folder, recipe))
        return 0;
    io::AtomicFolder target(
        folder, {"made scenes",
                 recipe_file,
                 {"test/*/depth/*.png", "test/*/scene_camera.json", "test/*/scene_gt.json", "test/*/scene_gt_info.json",
                  "models/obj_*.ply", "models/models_info.json", "camera.json", "test_targets_bop19.json"},
                 "faster-scenes"});
    DatasetMaker maker(target.path(), setting, std::move(meshes), seed);
    maker.make(jobs, progress);
    io::write_file(target.path() / recipe_file, recipe);
    target.commit();
    return maker.missed();
}

}  // namespace faster::experiments
