#include "workload/experiments/made_dataset.hpp"

#include <fmt/format.h>
#include <mutex>

#include "kernel/base/files/atomic_folder.hpp"
#include "kernel/base/files/text_file.hpp"
#include "kernel/base/json.hpp"
#include "kernel/base/on_threads.hpp"
#include "workload/bop/write_dataset.hpp"
#include "workload/experiments/made_scene.hpp"
#include "workload/experiments/ycb_classes.hpp"
#include "workload/files/png_image.hpp"
#include "workload/models/builtin_models.hpp"

namespace faster::experiments {

namespace {

namespace fs = std::filesystem;

constexpr char const* recipe_file = "scenes.json";

/// What the images depend on; of another version of the generator as well.
std::string recipe_of(Setting const& setting, std::uint64_t seed) {
    Json const recipe{{"format", "faster-scenes"},
                      {"version", 1},
                      {"seed", seed},
                      {"objects", setting.objects},
                      {"images", setting.images},
                      {"visible", setting.visible}};
    return recipe.dump(1) + "\n";
}

bool holds(fs::path const& folder, std::string const& recipe) {
    return fs::exists(folder / recipe_file) && io::read_file(folder / recipe_file) == recipe;
}

class DatasetMaker {
  public:
    DatasetMaker(fs::path folder, Setting const& setting, std::uint64_t seed)
        : folder_(std::move(folder)), setting_(setting), seed_(seed) {
        for (std::string const& name : ycb_classes()) {
            int const id = obj_id_of(name);
            meshes_[id] = models::make(name);
            models_[id].obj_id = id;
            add_symmetries(models_[id], name);
        }
    }

    void make(std::size_t jobs, std::function<void(std::size_t, std::size_t)> const& progress) {
        make_folders();
        write_models();
        make_images(jobs, progress);
        for (std::string const& name : setting_.objects)
            write_scene(obj_id_of(name));
        write_camera_and_targets();
    }

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
        io::write_file(folder_ / "models" / "models_info.json", bop::models_info_json(models_, meshes_));
    }

    void make_images(std::size_t jobs, std::function<void(std::size_t, std::size_t)> const& progress) {
        images_.resize(setting_.objects.size() * per_class());
        std::mutex mutex;
        std::size_t done = 0;
        on_threads(images_.size(), jobs, [&](std::size_t i) {
            images_[i] = made_image(obj_id_of(setting_.objects[i / per_class()]), static_cast<int>(i % per_class()));
            std::lock_guard<std::mutex> const lock(mutex);
            progress(++done, images_.size());
        });
    }

    bop::DatasetImage made_image(int obj_id, int number) const {
        MadeScene scene =
            made_scene({obj_id, setting_.visible, seed_, static_cast<std::uint64_t>(number)}, meshes_, camera_);
        bop::DatasetImage image;
        image.id = {obj_id, number};
        image.camera = camera_;
        image.depth_unit_m = bop::written_depth_unit_m;
        image.objects = std::move(scene.objects);
        io::write_png(scene_folder(obj_id) / "depth" / fmt::format("{:06}.png", number),
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
    std::map<int, bop::ObjectModel> models_;
    std::vector<bop::DatasetImage> images_;
};

}  // namespace

void make_dataset(fs::path const& folder, Setting const& setting, std::uint64_t seed, std::size_t jobs,
                  std::function<void(std::size_t, std::size_t)> const& progress) {
    std::string const recipe = recipe_of(setting, seed);
    if (holds(folder, recipe))
        return;
    io::AtomicFolder target(folder,
                            {"made scenes", recipe_file, {"test", "models", "camera.json", "test_targets_bop19.json"}});
    DatasetMaker(target.path(), setting, seed).make(jobs, progress);
    io::write_file(target.path() / recipe_file, recipe);
    target.commit();
}

}  // namespace faster::experiments
