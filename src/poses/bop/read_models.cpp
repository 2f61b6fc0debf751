#include "poses/bop/read_models.hpp"

#include <charconv>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <set>

#include "dataflow/base/files/file_error.hpp"
#include "dataflow/base/files/json_file.hpp"
#include "dataflow/base/files/json_node.hpp"
#include "dataflow/base/input_error.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/workload/files/mesh_file.hpp"
#include "faster/workload/files/pose_numbers.hpp"
#include "poses/bop/mended_rotations.hpp"

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

/// As T-LESS has only models_cad and models_eval.
[[noreturn]] void fail_without(fs::path const& folder) {
    std::set<std::string> others;
    if (fs::is_directory(folder.parent_path()))
        for (auto const& entry : fs::directory_iterator(folder.parent_path()))
            if (entry.path().filename().string().rfind("models_", 0) == 0)
                others.insert(entry.path().filename().string());
    io::fail(folder,
             "no such folder, expected one with models" +
                 (others.empty() ? "" : fmt::format(", or a link of that name to {}", fmt::join(others, " or "))));
}

std::set<fs::path> meshes_in(fs::path const& folder) {
    if (!fs::is_directory(folder))
        fail_without(folder);
    std::set<fs::path> meshes;
    for (auto const& entry : fs::directory_iterator(folder)) {
        if (files::has_mesh_extension(entry.path()))
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

std::map<int, ObjectModel> models_by_number(std::set<fs::path> const& meshes, std::optional<double> unit_m) {
    std::map<int, ObjectModel> models;
    for (fs::path const& mesh : meshes) {
        auto const id = numbered_object(mesh.stem().string());
        if (!id)
            continue;
        auto const [found, is_new] = models.emplace(*id, model_named(mesh, *id, unit_m.value_or(files::m_per_mm)));
        if (!is_new)
            io::fail(mesh, fmt::format("is object {}, as {} is, expected one mesh of an object", *id,
                                       found->second.mesh.filename().string()));
    }
    return models;
}

std::map<int, ObjectModel> models_by_name(std::set<fs::path> const& meshes, std::optional<double> unit_m) {
    std::map<int, ObjectModel> models;
    for (fs::path const& mesh : meshes) {
        int const id = static_cast<int>(models.size()) + 1;
        for (auto const& [other_id, other] : models)
            if (other.name == mesh.stem().string())
                io::fail(mesh, fmt::format("is a mesh of {}, as {} is, expected one mesh of a class", other.name,
                                           other.mesh.filename().string()));
        models[id] = model_named(mesh, id, unit_m.value_or(1));
    }
    return models;
}

/// A symmetry: a 4 x 4 matrix, row by row, that maps the model to itself [mm].
Pose read_symmetry(io::JsonNode const& node, MendedRotations& mended) {
    std::vector<double> const m = node.numbers(16);
    if (m[12] != 0 || m[13] != 0 || m[14] != 0 || m[15] != 1)
        node.fail("0, 0, 0, 1 as its last row");
    Pose pose;
    std::string problem;
    pose.rotation = mended.taken(files::matrix_of({m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]}), problem);
    pose.translation = files::m_per_mm * Eigen::Vector3d(m[3], m[7], m[11]);
    if (!problem.empty())
        node.fail(problem + " and a translation");
    return pose;
}

Eigen::Vector3d vector_of(std::vector<double> const& numbers) { return {numbers[0], numbers[1], numbers[2]}; }

ObjectModel::Axis read_axis(io::JsonNode const& node) {
    Eigen::Vector3d const direction = vector_of(node.at("axis").numbers(3));
    if (!(direction.norm() > 0))
        node.at("axis").fail("a direction, not 0 0 0");
    return {direction.normalized(), files::m_per_mm * vector_of(node.at("offset").numbers(3))};
}

std::optional<ObjectModel::Bounds> read_bounds(io::JsonNode const& info) {
    ObjectModel::Bounds bounds;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        std::string const name(1, "xyz"[axis]);
        auto const min = info.find("min_" + name), size = info.find("size_" + name);
        if (!min || !size)
            return std::nullopt;
        bounds.min(axis) = files::m_per_mm * min->number();
        bounds.size(axis) = files::m_per_mm * size->number();
    }
    return bounds;
}

void read_info(io::JsonNode const& info, ObjectModel& model, MendedRotations& mended) {
    model.diameter_m = files::m_per_mm * info.at("diameter").number_above_zero();
    model.bounds = read_bounds(info);
    if (auto const discrete = info.find("symmetries_discrete")) {
        for (io::JsonNode const& symmetry : discrete->items())
            model.symmetries.push_back(read_symmetry(symmetry, mended));
    }
    if (auto const continuous = info.find("symmetries_continuous")) {
        for (io::JsonNode const& axis : continuous->items())
            model.axes.push_back(read_axis(axis));
    }
}

void read_infos(fs::path const& file, std::map<int, ObjectModel>& models, std::vector<std::string>& warnings) {
    Json const json = io::read_json_file(file, "models_info.json as BOP has it");
    for (auto& [id, model] : models)
        model.problem =
            fmt::format("{}: no key {}, expected one for {}", file.string(), id, model.mesh.filename().string());
    MendedRotations mended;
    for (auto const& [id, info] : io::JsonNode(file, json).numbered()) {
        auto const found = models.find(id);
        if (found == models.end())
            continue;
        ObjectModel& model = found->second;
        model.problem.clear();
        model.info = file;
        read_into(model, [&] { read_info(info, model, mended); });
    }
    mended.tell(file.string(), warnings);
}
}  // namespace

std::map<int, ObjectModel> read_models_folder(fs::path const& folder, std::optional<double> unit_m,
                                              std::vector<std::string>& warnings, fs::path const& other_infos) {
    std::set<fs::path> const meshes = meshes_in(folder);
    std::map<int, ObjectModel> models = models_by_number(meshes, unit_m);
    bool const is_bop = !models.empty();
    if (!is_bop)
        models = models_by_name(meshes, unit_m);
    fs::path infos = folder / "models_info.json";
    if (is_bop && !fs::exists(infos) && fs::exists(other_infos))
        infos = other_infos;
    if (is_bop || fs::exists(infos))
        read_infos(infos, models, warnings);
    return models;
}

}  // namespace faster::bop
