#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "dataflow/base/files/json_node.hpp"
#include "poses/bop/dataset.hpp"

namespace faster::bop {

/// A box [x, y, width, height] of a JSON file; nothing for one of four times -1, which is that of what is not seen.
/// Throws InputError, also for another negative size.
std::optional<ImageBox> read_box(io::JsonNode const& node);

/// A box in which a detector saw an object.
struct Detection {
    ImageId image;
    int obj_id = 0;
    ImageBox box;
    double score = 0;          ///< the detector's confidence, 0..1
    double time_s = -1;        ///< that it took for the whole image; -1 unknown
    std::string problem = {};  ///< what is wrong with its box in the file, see sound()
};

/// Reads detections as BOP has them, a JSON array of COCO-style objects: scene_id, image_id, category_id, bbox
/// [x, y, width, height], score and, if known, time. Masks and other members are skipped. Scores beyond 0 and 1 become
/// the nearer of the two, a missing one 1; `warnings` tell of it. Throws InputError.
std::vector<Detection> read_detections(std::filesystem::path const& path, std::vector<std::string>& warnings);

/// Detections as the text of a file.
std::string detections_json(std::vector<Detection> const& detections);

}  // namespace faster::bop
