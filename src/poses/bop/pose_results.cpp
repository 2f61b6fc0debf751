#include "poses/bop/pose_results.hpp"

#include <cmath>
#include <fmt/format.h>
#include <map>
#include <string_view>

#include "dataflow/base/files/csv_cells.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/workload/files/pose_numbers.hpp"
#include "faster/workload/files/table_row.hpp"
#include "poses/bop/mended_rotations.hpp"

namespace faster::bop {
namespace {

enum Column { scene_id, im_id, obj_id, score, rotation, translation, time };

PoseEstimate read_estimate(files::TableRow const& row, MendedRotations& mended) {
    PoseEstimate estimate;
    estimate.image = {row.id(scene_id), row.id(im_id)};
    estimate.obj_id = row.id(obj_id);
    estimate.score = row.number(score);
    std::string problem;
    estimate.pose.rotation = mended.taken(files::matrix_of(row.numbers(rotation, 9)), problem);
    estimate.problem = problem.empty() ? "" : row.complaint(rotation, problem);
    estimate.pose.translation = files::m_per_mm * row.vector(translation);
    estimate.time_s = row.number(time);
    return estimate;
}

std::string csv_row(PoseEstimate const& estimate) {
    Eigen::Vector3d const t = estimate.pose.translation / files::m_per_mm;
    return fmt::format("{},{},{},{},{},{} {} {},{}\n", estimate.image.scene_id, estimate.image.im_id, estimate.obj_id,
                       estimate.score, files::row_major_text(estimate.pose.rotation), t.x(), t.y(), t.z(),
                       estimate.time_s);
}

/// bop_toolkit refuses files of which an image's rows differ in time by more than a millisecond.
void tell_of_times(std::filesystem::path const& path, std::vector<PoseEstimate> const& estimates,
                   std::vector<std::string>& warnings) {
    constexpr double most_s = 0.001;
    std::map<ImageId, double> times;
    for (PoseEstimate const& estimate : estimates) {
        if (estimate.time_s < 0)
            continue;
        double const first_s = times.emplace(estimate.image, estimate.time_s).first->second;
        if (std::abs(first_s - estimate.time_s) > most_s)
            return warnings.push_back(fmt::format(
                "{}:{}: time = {}, expected {} as in the rows before of image {} of scene {}: the image's whole time",
                path.string(), estimate.line, estimate.time_s, first_s, estimate.image.im_id, estimate.image.scene_id));
    }
}

}  // namespace

std::vector<PoseEstimate> read_pose_results(std::filesystem::path const& path, std::vector<std::string>& warnings) {
    std::vector<PoseEstimate> estimates;
    MendedRotations mended;
    std::vector<std::string> const& columns = files::columns_of_results();
    io::read_csv_cells_of(path, columns, columns, [&](std::size_t line, std::string_view const* cells) {
        estimates.push_back(read_estimate(files::TableRow(path, columns, line, cells), mended));
        estimates.back().line = line;
    });
    mended.tell(path.string(), warnings);
    tell_of_times(path, estimates, warnings);
    return estimates;
}

std::string pose_results_csv(std::vector<PoseEstimate> const& estimates) {
    std::string text = fmt::format("{}\n", fmt::join(files::columns_of_results(), ","));
    for (PoseEstimate const& estimate : estimates)
        text += csv_row(estimate);
    return text;
}

}  // namespace faster::bop
