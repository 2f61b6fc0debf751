#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "faster/data/mesh.hpp"

namespace faster::workload {

/// The poses of a table, one per row, in its order: of the columns `R`, nine numbers row by row, and `t_m`, three [m],
/// or else `t`, three [mm], as BOP's results have it; object to camera. Others are skipped. Throws InputError
/// (file:line): a missing column, a cell that is no finite number, too few or many of them, a matrix that is no
/// rotation, no row at all.
std::vector<Pose> read_pose_list(std::filesystem::path const& path);

/// Poses as a table: sample,R,t_m. read_pose_list() brings back the same ones.
std::string pose_list_csv(std::vector<Pose> const& poses);

}  // namespace faster::workload
