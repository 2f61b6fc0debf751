#include "poses/bop/odd_lengths.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "faster/dataflow_names.hpp"
#include "faster/workload/object_mesh.hpp"

namespace faster::bop {

void tell_of_translations(Dataset& dataset, std::string const& place, double unit_m) {
    constexpr double least_m = 0.02, most_m = 100;
    std::vector<double> distances_m;
    for (DatasetImage const& image : dataset.images) {
        for (GroundTruth const& object : image.objects)
            distances_m.push_back(object.pose.translation.norm());
    }
    if (distances_m.empty())
        return;
    auto const middle = distances_m.begin() + static_cast<std::ptrdiff_t>(distances_m.size() / 2);
    std::nth_element(distances_m.begin(), middle, distances_m.end());
    if (*middle < least_m || *middle > most_m)
        dataset.warnings.push_back(
            fmt::format("{} puts half of the objects {} than {:.3g} {} from the camera, expected {}", place,
                        *middle < least_m ? "no farther" : "farther", *middle / unit_m, unit_m == 1 ? "m" : "mm",
                        unit_m == 1 ? "metres" : "millimetres"));
}

void tell_of_length(Mesh const& mesh, ObjectModel const& model, std::vector<std::string>& warnings) {
    std::string const odd = model.info.empty() ? workload::length_warning(mesh, model.mesh.string()) : "";
    if (!odd.empty())
        warnings.push_back(fmt::format("{} (read in {}; --models-in of estimate and evaluate)", odd,
                                       model.unit_m == 1 ? "metres" : "millimetres"));
}

}  // namespace faster::bop
