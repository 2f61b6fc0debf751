#include "poses/bop/detections.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "dataflow/base/files/json_file.hpp"
#include "faster/dataflow_names.hpp"

namespace faster::bop {

namespace {

class DetectionReader {
  public:
    Detection read(io::JsonNode const& node) {
        Detection detection;
        detection.image = {node.at("scene_id").integer(0), node.at("image_id").integer(0)};
        detection.obj_id = node.at("category_id").integer(0);
        read_into(detection, [&] { read_rest(node, detection); });
        return detection;
    }
    std::vector<std::string> warnings(std::filesystem::path const& path) const {
        std::vector<std::string> warnings;
        if (missing_ > 0)
            warnings.push_back(
                fmt::format("{}: {} of {} detections have no score, expected a confidence from 0 to 1: "
                            "taken for 1",
                            path.string(), missing_, read_));
        if (boxes_ > 0 && boxes_ == boxes_within_one_)
            warnings.push_back(fmt::format(
                "{}: all boxes lie within 0 and 1, expected pixels, not shares of the image's sides", path.string()));
        return warnings;
    }

  private:
    void read_rest(io::JsonNode const& node, Detection& detection) {
        ++read_;
        std::optional<ImageBox> const box = read_box(node.at("bbox"));
        if (!box || box->width == 0 || box->height == 0)
            node.at("bbox").fail("a box of something seen");
        detection.box = *box;
        ++boxes_;
        boxes_within_one_ += is_within_one(*box) ? 1U : 0U;
        detection.score = confidence(node);
        if (auto const time = node.find("time"); time && !time->value().is_null())
            detection.time_s = time->number();
    }

    static bool is_within_one(ImageBox const& box) {
        return box.left >= 0 && box.top >= 0 && box.left + box.width <= 1 && box.top + box.height <= 1;
    }

    double confidence(io::JsonNode const& node) {
        auto const score = node.find("score");
        if (!score || score->value().is_null()) {
            ++missing_;
            return 1;
        }
        constexpr double rounding = 1e-6;
        double const given = score->number(), taken = std::clamp(given, 0.0, 1.0);
        if (std::abs(given - taken) > rounding)
            score->fail("a confidence from 0 to 1");
        return taken;
    }

    std::size_t read_ = 0, missing_ = 0;
    std::size_t boxes_ = 0, boxes_within_one_ = 0;
};

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

std::optional<ImageBox> read_box(io::JsonNode const& node) {
    std::vector<double> const numbers = node.numbers(4);
    if (std::all_of(numbers.begin(), numbers.end(), [](double number) { return number == -1; }))
        return std::nullopt;
    if (numbers[2] < 0 || numbers[3] < 0)
        node.fail("a box x, y, width, height of no negative size");
    constexpr double most_px = 1e6;  // far beyond any image, and within what samples' pixels can be
    if (std::any_of(numbers.begin(), numbers.end(), [](double number) { return std::abs(number) > most_px; }))
        node.fail("a box x, y, width, height of no more than a million pixels each");
    return ImageBox{numbers[0], numbers[1], numbers[2], numbers[3]};
}

std::vector<Detection> read_detections(std::filesystem::path const& path, std::vector<std::string>& warnings) {
    Json const file = io::read_json_file(path, "detections as BOP has them");
    DetectionReader reader;
    std::vector<Detection> detections;
    for (io::JsonNode const& node : io::JsonNode(path, file).items())
        detections.push_back(reader.read(node));
    std::vector<std::string> const told = reader.warnings(path);
    warnings.insert(warnings.end(), told.begin(), told.end());
    return detections;
}

std::string detections_json(std::vector<Detection> const& detections) {
    Json file = Json::array();
    for (Detection const& detection : detections)
        file.push_back(json_of(detection));
    return file.dump(1) + "\n";
}

}  // namespace faster::bop
