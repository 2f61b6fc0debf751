#include "workload/bop/models_folder.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <set>

#include "kernel/base/files/file_error.hpp"
#include "kernel/base/files/json_file.hpp"
#include "workload/bop/json_node.hpp"
#include "workload/files/mesh_file.hpp"
#include "workload/files/pose_numbers.hpp"

namespace faster::bop {
namespace {

namespace fs = std::filesystem;

/// The number in obj_NNNNNN; nothing for another name.
std::optional<int> numbered_object(std::string const& stem) {
    constexpr std::string_view prefix = "obj_";
    int id = 0;
    char const* const end = stem.data() + stem.size();
    if (stem.rfind(prefix, 0) != 0)
        return std::nullopt;
    auto const result = std::from_chars(stem.data() + prefix.size(), end, id);
    return result.ec == std::errc{} && result.ptr == end && id > 0 ? std::optional(id) : std::nullopt;
}

std::set<fs::path> meshes_in(fs::path const& folder) {
    if (!fs::is_directory(folder))
        io::fail(folder, "no such folder, expected one with models");
    std::set<fs::path> meshes;
    for (auto const& entry : fs::directory_iterator(folder)) {
        if (io::has_mesh_extension(entry.path()))
            meshes.insert(entry.path());
    }
    if (meshes.empty())
        io::fail(folder, "holds no meshes, expected obj_NNNNNN.ply, or a mesh file per class");
    return meshes;
}

ObjectModel model_named(fs::path const& mesh, int obj_id, double unit_m) {
    ObjectModel model;
    model.obj_id = obj_id;
    model.name = mesh.stem().string();
    model.mesh = mesh;
    model.unit_m = unit_m;
    return model;
}

std::map<int, ObjectModel> models_by_number(std::set<fs::path> const& meshes) {
    std::map<int, ObjectModel> models;
    for (fs::path const& mesh : meshes) {
        if (auto const id = numbered_object(mesh.stem().string()))
            models[*id] = model_named(mesh, *id, io::m_per_mm);
    }
    return models;
}

std::map<int, ObjectModel> models_by_name(std::set<fs::path> const& meshes) {
    std::map<int, ObjectModel> models;
    for (fs::path const& mesh : meshes) {
        int const id = static_cast<int>(models.size()) + 1;
        models[id] = model_named(mesh, id, 1);
    }
    return models;
}

/// A symmetry: a 4 x 4 matrix, row by row, that maps the model to itself [mm].
Pose read_symmetry(JsonNode const& node) {
    std::vector<double> const m = node.numbers(16);
    Pose pose;
    pose.rotation = io::matrix_of({m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]});
    pose.translation = io::m_per_mm * Eigen::Vector3d(m[3], m[7], m[11]);
    if (std::string const problem = io::rotation_problem(pose.rotation); !problem.empty())
        node.fail(problem + " and a translation");
    return pose;
}

Eigen::Vector3d vector_of(std::vector<double> const& numbers) { return {numbers[0], numbers[1], numbers[2]}; }

ObjectModel::Axis read_axis(JsonNode const& node) {
    Eigen::Vector3d const direction = vector_of(node.at("axis").numbers(3));
    if (!(direction.norm() > 0))
        node.at("axis").fail("a direction, not 0 0 0");
    return {direction.normalized(), io::m_per_mm * vector_of(node.at("offset").numbers(3))};
}

void read_info(JsonNode const& info, ObjectModel& model) {
    model.diameter_m = io::m_per_mm * info.at("diameter").number_above_zero();
    if (auto const discrete = info.find("symmetries_discrete")) {
        for (JsonNode const& symmetry : discrete->items())
            model.symmetries.push_back(read_symmetry(symmetry));
    }
    if (auto const continuous = info.find("symmetries_continuous")) {
        for (JsonNode const& axis : continuous->items())
            model.axes.push_back(read_axis(axis));
    }
}

void read_infos(fs::path const& file, std::map<int, ObjectModel>& models) {
    Json const json = io::read_json_file(file, "models_info.json as BOP has it");
    for (auto const& [id, info] : JsonNode(file, json).numbered()) {
        if (auto const model = models.find(id); model != models.end())
            read_info(info, model->second);
    }
    for (auto const& [id, model] : models) {
        if (!model.diameter_m)
            io::fail(file, fmt::format("no key {}, expected one for {}", id, model.mesh.filename().string()));
    }
}

}  // namespace

std::map<int, ObjectModel> read_models_folder(fs::path const& folder) {
    std::set<fs::path> const meshes = meshes_in(folder);
    std::map<int, ObjectModel> models = models_by_number(meshes);
    bool const is_bop = !models.empty();
    if (!is_bop)
        models = models_by_name(meshes);
    fs::path const infos = folder / "models_info.json";
    if (is_bop || fs::exists(infos))
        read_infos(infos, models);
    return models;
}

}  // namespace faster::bop
