#include "poses/bop/odd_lengths.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "dataflow/base/middle_of.hpp"
#include "dataflow/base/portable_math.hpp"
#include "faster/data/mesh_size.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/workload/files/pose_numbers.hpp"
#include "faster/workload/object_mesh.hpp"

namespace faster::bop {
namespace {

constexpr double mm_per_metre = 1 / files::m_per_mm;

ObjectModel::Bounds bounds_of(Mesh const& mesh) {
    Eigen::AlignedBox3d const box = box_of(mesh);
    return {box.min(), box.sizes()};
}

std::string mm_text(Eigen::Vector3d const& v) {
    return fmt::format("{:.4g} x {:.4g} x {:.4g} mm", mm_per_metre * v.x(), mm_per_metre * v.y(), mm_per_metre * v.z());
}

std::string info_text(ObjectModel const& model) {
    std::string text = fmt::format("object {} has diameter {:.4g}", model.obj_id, mm_per_metre * *model.diameter_m);
    if (model.bounds)
        text += ", and is " + mm_text(model.bounds->size);
    return text;
}

/// The diameter of what reaches furthest in any of many directions. At most 1 % too small, as one of them is within 8
/// degrees of any direction; to compare all vertices with all others would take too long.
double diameter_about(std::vector<Eigen::Vector3d> const& vertices) {
    constexpr int directions = 240;
    double const golden_angle = dataflow::portable::pi * (3 - std::sqrt(5.0));
    std::vector<Eigen::Vector3d> furthest;
    std::vector<double> reach(vertices.size());
    for (int i = 0; i < directions; ++i) {  // along a spiral over the half of a sphere
        double const z = (i + 0.5) / directions, radius = std::sqrt(1 - z * z), angle = i * golden_angle;
        Eigen::Vector3d const direction(radius * std::cos(angle), radius * std::sin(angle), z);
        std::transform(vertices.begin(), vertices.end(), reach.begin(),
                       [&](Eigen::Vector3d const& vertex) { return direction.dot(vertex); });
        for (auto const place :
             {std::min_element(reach.begin(), reach.end()), std::max_element(reach.begin(), reach.end())})
            furthest.push_back(vertices[static_cast<std::size_t>(place - reach.begin())]);
    }
    return diameter_of(furthest);
}

/// How many times as large as told the mesh is, by its longest side or its diameter, whichever is farther off.
double ratio(ObjectModel::Bounds const& found, double diameter_m, ObjectModel const& model) {
    double const of_diameter = diameter_m / *model.diameter_m;
    if (!model.bounds || !(model.bounds->size.maxCoeff() > 0))
        return of_diameter;
    double const of_sizes = found.size.maxCoeff() / model.bounds->size.maxCoeff();
    return std::abs(std::log(of_sizes)) > std::abs(std::log(of_diameter)) ? of_sizes : of_diameter;
}

/// The largest difference of a corner of the two boxes, in diameters.
double shift(ObjectModel::Bounds const& found, ObjectModel const& model) {
    if (!model.bounds)
        return 0;
    Eigen::Vector3d const low = found.min - model.bounds->min, high = low + found.size - model.bounds->size;
    return std::max(low.cwiseAbs().maxCoeff(), high.cwiseAbs().maxCoeff()) / *model.diameter_m;
}

/// The option that reads the meshes in another unit, if the ratio is that of the units.
std::string unit_help(double larger, double unit_m) {
    double const right_unit_m = unit_m / larger;
    auto const is_about = [&](double wanted_m) { return right_unit_m > wanted_m / 2 && right_unit_m < wanted_m * 2; };
    for (auto const& [unit, length_m] : {std::pair("m", 1.0), std::pair("mm", files::m_per_mm)}) {
        if (is_about(length_m))
            return fmt::format("; meshes in {0}, poses in mm: estimate and evaluate with --models-in {0}", unit);
    }
    return "";
}

}  // namespace

void compare_with_info(Mesh const& mesh, ObjectModel const& model, std::vector<std::string>& warnings) {
    if (!model.diameter_m || model.info.empty() || mesh.vertices.empty())
        return;
    constexpr double contradicts = 2, is_odd = 1.1, odd_shift = 0.05, least_m = 0.003, most_m = 10;
    ObjectModel::Bounds const found = bounds_of(mesh);
    double const diameter_m = diameter_about(mesh.vertices);
    double const larger = ratio(found, diameter_m, model), away = std::max(larger, 1 / larger);
    std::string const both =
        fmt::format("{}: is {}, of diameter {:.4g}, but by {} {}", model.mesh.string(), mm_text(found.size),
                    mm_per_metre * diameter_m, model.info.string(), info_text(model));
    if (!(away < contradicts))
        throw InputError(fmt::format("{}: {:.4g} times as large, expected the same{}", both, larger,
                                     unit_help(larger, model.unit_m)));
    if (*model.diameter_m < least_m || *model.diameter_m > most_m)
        warnings.push_back(both + ", expected millimetres: lengths of some centimetres");
    if (away > is_odd || shift(found, model) > odd_shift)
        warnings.push_back(both + (model.bounds ? fmt::format(" from {}", mm_text(model.bounds->min)) : std::string()) +
                           ", expected the same: another mesh, other axes, or moved");
}

void tell_of_translations(Dataset& dataset, std::string const& place, double unit_m) {
    constexpr double least_m = 0.02, most_m = 100;
    std::vector<double> distances_m;
    for (DatasetImage const& image : dataset.images) {
        for (GroundTruth const& object : image.objects) {
            if (object.problem.empty())
                distances_m.push_back(object.pose.translation.norm());
        }
    }
    if (distances_m.empty())
        return;
    double const middle_m = middle_of(distances_m);
    if (middle_m < least_m || middle_m > most_m)
        dataset.warnings.push_back(
            fmt::format("{} puts half of the objects {} than {:.3g} {} from the camera, expected {}", place,
                        middle_m < least_m ? "no farther" : "farther", middle_m / unit_m, unit_m == 1 ? "m" : "mm",
                        unit_m == 1 ? "metres" : "millimetres"));
}

void tell_of_length(Mesh const& mesh, ObjectModel const& model, std::vector<std::string>& warnings) {
    std::string const odd = model.info.empty() ? workload::length_warning(mesh, model.mesh.string()) : "";
    if (!odd.empty())
        warnings.push_back(fmt::format("{} (read in {}; --models-in of estimate and evaluate)", odd,
                                       model.unit_m == 1 ? "metres" : "millimetres"));
}

}  // namespace faster::bop
