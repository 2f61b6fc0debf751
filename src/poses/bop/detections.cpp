#include "poses/bop/detections.hpp"

#include "dataflow/base/files/json_file.hpp"
#include "faster/dataflow_names.hpp"

namespace faster::bop {

namespace {

Detection read_detection(JsonNode const& node) {
    Detection detection;
    detection.image = {node.at("scene_id").integer(0), node.at("image_id").integer(0)};
    detection.obj_id = node.at("category_id").integer(1);
    detection.box = read_box(node.at("bbox"));
    detection.score = node.at("score").number();
    if (auto const time = node.find("time"))
        detection.time_s = time->number();
    return detection;
}

Json json_of(Detection const& detection) {
    ImageBox const& box = detection.box;
    return {{"scene_id", detection.image.scene_id},
            {"image_id", detection.image.im_id},
            {"category_id", detection.obj_id},
            {"bbox", {box.left, box.top, box.width, box.height}},
            {"score", detection.score},
            {"time", detection.time_s}};
}

}  // namespace

ImageBox read_box(JsonNode const& node) {
    std::vector<double> const numbers = node.numbers(4);
    if (numbers[2] < 0 || numbers[3] < 0)
        node.fail("a box x, y, width, height of no negative size");
    return {numbers[0], numbers[1], numbers[2], numbers[3]};
}

std::vector<Detection> read_detections(std::filesystem::path const& path) {
    Json const file = io::read_json_file(path, "detections as BOP has them");
    std::vector<Detection> detections;
    for (JsonNode const& node : JsonNode(path, file).items())
        detections.push_back(read_detection(node));
    return detections;
}

std::string detections_json(std::vector<Detection> const& detections) {
    Json file = Json::array();
    for (Detection const& detection : detections)
        file.push_back(json_of(detection));
    return file.dump(1) + "\n";
}

}  // namespace faster::bop
