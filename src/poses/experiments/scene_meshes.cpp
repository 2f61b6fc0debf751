#include "poses/experiments/scene_meshes.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <fmt/format.h>
#include <string>
#include <vector>

#include "dataflow/base/input_error.hpp"
#include "faster/data/mesh_size.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/workload/files/mesh_file.hpp"
#include "faster/workload/models/builtin_models.hpp"
#include "faster/workload/object_mesh.hpp"
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

void require_one_per_class(std::vector<fs::path> const& files) {
    std::map<int, fs::path> first;
    for (fs::path const& file : files) {
        int const id = obj_id_of_file(file);
        auto const [found, is_new] = first.emplace(id, file);
        if (!is_new)
            throw InputError(fmt::format("{}: is a mesh of {}, as {} is, expected one mesh of a class", file.string(),
                                         ycb_classes()[static_cast<std::size_t>(id) - 1],
                                         found->second.filename().string()));
    }
}

void move_to_middle(Mesh& mesh) {
    Eigen::Vector3d const middle = box_of(mesh).center();
    for (Eigen::Vector3d& vertex : mesh.vertices)
        vertex -= middle;
}

/// Of another unit, or larger than what the camera sees of the table.
std::string odd_size(Mesh const& mesh, std::string const& file) {
    constexpr double sight_m = 0.8;
    std::string const odd = workload::length_warning(mesh, file);
    double const side_m = workload::longest_side_m(mesh);
    return odd.empty() && side_m > sight_m
               ? fmt::format("{}: is {:.4g} m long; expected less than {} m", file, side_m, sight_m)
               : odd;
}

}  // namespace

std::map<int, Mesh> scene_meshes(fs::path const& folder, std::size_t jobs, std::vector<std::string>& warnings) {
    std::map<int, Mesh> meshes;
    if (folder.empty()) {
        for (std::string const& name : ycb_classes())
            meshes[obj_id_of(name)] = models::make(name);
        return meshes;
    }
    std::vector<fs::path> const files = files_in(folder);
    require_one_per_class(files);
    std::vector<Mesh> loaded = files::load_meshes(files, {}, jobs);
    for (std::size_t i = 0; i < files.size(); ++i) {
        move_to_middle(loaded[i]);
        if (std::string const odd = odd_size(loaded[i], files[i].string()); !odd.empty())
            warnings.push_back(odd + ", as scenes are made of meshes in metres");
        meshes[obj_id_of_file(files[i])] = std::move(loaded[i]);
    }
    return meshes;
}

}  // namespace faster::experiments
