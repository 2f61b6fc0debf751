#include "faster/workload/pose_list.hpp"

#include <fmt/format.h>
#include <string_view>

#include "dataflow/base/files/csv_cells.hpp"
#include "dataflow/base/input_error.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/workload/files/pose_numbers.hpp"
#include "faster/workload/files/table_row.hpp"

namespace faster::workload {

static constexpr std::size_t most_poses = 1'000'000;  // as workload.samples.count

std::vector<Pose> read_pose_list(std::filesystem::path const& path) {
    bool const is_in_mm = io::is_row_first(path) || (!io::has_csv_column(path, "t_m") && io::has_csv_column(path, "t"));
    std::vector<std::string> const columns{"R", is_in_mm ? "t" : "t_m"};
    std::vector<Pose> poses;
    auto const read_row = [&](std::size_t line, std::string_view const* cells) {
        files::TableRow const row(path, columns, line, cells);
        if (poses.size() == most_poses)
            throw InputError(fmt::format("{}:{}: another row, expected at most {}", path.string(), line, most_poses));
        poses.push_back({row.rotation(0), row.vector(1)});
        if (is_in_mm)
            poses.back().translation *= files::m_per_mm;
    };
    io::read_csv_cells_of(path, files::columns_of_results(), columns, read_row);
    if (poses.empty())
        throw InputError(path.string() + ": no rows, expected one per sample");
    return poses;
}

std::string pose_list_csv(std::vector<Pose> const& poses) {
    std::string text = "sample,R,t_m\n";
    for (std::size_t sample = 0; sample < poses.size(); ++sample) {
        Eigen::Vector3d const& t = poses[sample].translation;
        text +=
            fmt::format("{},{},{} {} {}\n", sample, files::row_major_text(poses[sample].rotation), t.x(), t.y(), t.z());
    }
    return text;
}

}  // namespace faster::workload
