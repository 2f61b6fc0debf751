#include "poses/experiments/scene_meshes.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <string>
#include <vector>

#include "dataflow/base/input_error.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/workload/files/mesh_file.hpp"
#include "faster/workload/models/builtin_models.hpp"
#include "poses/experiments/ycb_classes.hpp"

namespace faster::experiments {

namespace {

namespace fs = std::filesystem;

/// 0 for a file that is called otherwise.
int obj_id_of_file(fs::path const& file) {
    std::string const stem = file.stem();
    std::size_t const number = stem.find_first_not_of("0123456789");
    bool const has_number = number != 0 && number != std::string::npos && stem[number] == '_';
    return obj_id_of(has_number ? stem.substr(number + 1) : stem);
}

std::vector<fs::path> files_in(fs::path const& folder) {
    std::error_code error;
    fs::directory_iterator const entries(folder, error);
    if (error)
        throw InputError(folder.string() + ": cannot be read (" + error.message() + "), expected a folder of meshes");
    std::vector<fs::path> files;
    for (fs::directory_entry const& entry : entries)
        if (files::has_mesh_extension(entry.path()) && obj_id_of_file(entry.path()) != 0)
            files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    if (files.empty())
        throw InputError(folder.string() + ": has no mesh of a class, expected files like cracker_box.obj");
    return files;
}

void move_to_middle(Mesh& mesh) {
    Eigen::AlignedBox3d box;
    for (Eigen::Vector3d const& vertex : mesh.vertices)
        box.extend(vertex);
    for (Eigen::Vector3d& vertex : mesh.vertices)
        vertex -= box.center();
}

}  // namespace

std::map<int, Mesh> scene_meshes(fs::path const& folder, std::size_t jobs) {
    std::map<int, Mesh> meshes;
    if (folder.empty()) {
        for (std::string const& name : ycb_classes())
            meshes[obj_id_of(name)] = models::make(name);
        return meshes;
    }
    std::vector<fs::path> const files = files_in(folder);
    std::vector<Mesh> loaded = files::load_meshes(files, {}, jobs);
    for (std::size_t i = 0; i < files.size(); ++i) {
        move_to_middle(loaded[i]);
        meshes[obj_id_of_file(files[i])] = std::move(loaded[i]);
    }
    return meshes;
}

}  // namespace faster::experiments
