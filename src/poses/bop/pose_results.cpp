#include "poses/bop/pose_results.hpp"

#include <fmt/format.h>
#include <string_view>

#include "dataflow/base/files/csv_cells.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/workload/files/pose_numbers.hpp"
#include "faster/workload/files/table_row.hpp"

namespace faster::bop {
namespace {

enum Column { scene_id, im_id, obj_id, score, rotation, translation, time };
std::vector<std::string> const& columns() {
    static std::vector<std::string> const names{"scene_id", "im_id", "obj_id", "score", "R", "t", "time"};
    return names;
}

PoseEstimate read_estimate(files::TableRow const& row) {
    PoseEstimate estimate;
    estimate.image = {row.id(scene_id), row.id(im_id)};
    estimate.obj_id = row.id(obj_id);
    estimate.score = row.number(score);
    estimate.pose.rotation = row.rotation(rotation);
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

}  // namespace

std::vector<PoseEstimate> read_pose_results(std::filesystem::path const& path) {
    std::vector<PoseEstimate> estimates;
    io::read_csv_cells(path, columns(), [&](std::size_t line, std::string_view const* cells) {
        estimates.push_back(read_estimate(files::TableRow(path, columns(), line, cells)));
        estimates.back().line = line;
    });
    return estimates;
}

std::string pose_results_csv(std::vector<PoseEstimate> const& estimates) {
    std::string text = fmt::format("{}\n", fmt::join(columns(), ","));
    for (PoseEstimate const& estimate : estimates)
        text += csv_row(estimate);
    return text;
}

}  // namespace faster::bop
