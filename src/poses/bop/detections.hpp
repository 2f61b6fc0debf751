#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "poses/bop/dataset.hpp"
#include "poses/bop/json_node.hpp"

namespace faster::bop {

/// A box [x, y, width, height] of a JSON file. Throws InputError, also for a negative size.
ImageBox read_box(JsonNode const& node);

/// A box in which a detector saw an object.
struct Detection {
    ImageId image;
    int obj_id = 0;
    ImageBox box;
    double score = 0;    ///< the detector's confidence
    double time_s = -1;  ///< that it took for the whole image; -1 unknown
};

/// Reads detections as BOP has them, a JSON array of COCO-style objects: scene_id, image_id, category_id, bbox
/// [x, y, width, height], score and, if known, time. Masks are skipped. Throws InputError.
std::vector<Detection> read_detections(std::filesystem::path const& path);

/// Detections as the text of a file.
std::string detections_json(std::vector<Detection> const& detections);

}  // namespace faster::bop
