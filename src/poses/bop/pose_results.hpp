#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "poses/bop/dataset.hpp"

namespace faster::bop {

/// Where a method says that an object is.
struct PoseEstimate {
    ImageId image;
    int obj_id = 0;
    double score = 0;
    Pose pose;                 ///< model to camera [m]
    double time_s = -1;        ///< that the whole image took; -1 unknown
    std::size_t line = 0;      ///< of the file that it was read from; 0 if it was not
    std::string problem = {};  ///< what is wrong with its rotation in the file, see sound()
};

/// Reads a file of results as BOP has them: CSV with the columns scene_id,im_id,obj_id,score,R,t,time, R being nine and
/// t three numbers parted by blanks [mm]; without a first line that names them, the columns are these. `warnings` tell
/// of rotations that were mended, and of images whose rows have several times. Throws InputError (file:line): a missing
/// column, a cell that is no finite number, too few or many of them.
std::vector<PoseEstimate> read_pose_results(std::filesystem::path const& path, std::vector<std::string>& warnings);

/// Estimates as the text of a file. Rotations, scores and times are read back as they were, translations to the last
/// bit but one.
std::string pose_results_csv(std::vector<PoseEstimate> const& estimates);

}  // namespace faster::bop
