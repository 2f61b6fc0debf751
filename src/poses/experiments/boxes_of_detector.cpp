#include "poses/experiments/boxes_of_detector.hpp"

#include <algorithm>
#include <cmath>

#include "dataflow/base/counter_random.hpp"
#include "faster/dataflow_names.hpp"

namespace faster::experiments {

namespace {

constexpr double right_confidence = 0.8, wrong_confidence = 0.5, confidence_deviation = 0.1;

bop::ImageBox disturbed(bop::ImageBox const& box, DetectorModel const& model, CounterRandom& random) {
    double const right = model.shift * random.normal(), down = model.shift * random.normal();
    double const wider = std::exp(model.scale * random.normal()), higher = std::exp(model.scale * random.normal());
    bop::ImageBox result;
    result.width = box.width * wider;
    result.height = box.height * higher;
    result.left = box.left + box.width * (0.5 + right) - result.width / 2;
    result.top = box.top + box.height * (0.5 + down) - result.height / 2;
    return result;
}

double confidence(double mean, CounterRandom& random) {
    return std::clamp(mean + confidence_deviation * random.normal(), 0.05, 1.0);
}

}  // namespace

std::vector<bop::Detection> boxes_of_detector(bop::Target const& target, std::size_t instance,
                                              bop::ImageBox const& truth, std::vector<bop::ImageBox> const& others,
                                              DetectorModel const& model, std::uint64_t seed) {
    constexpr std::uint32_t stream_of_boxes = 0xb0b0, streams_of_instance = 1U << 20U;
    CounterRandom random(seed,
                         (std::uint64_t{static_cast<std::uint32_t>(target.image.scene_id)} << 32U) +
                             static_cast<std::uint32_t>(target.image.im_id),
                         stream_of_boxes + static_cast<std::uint32_t>(target.obj_id) +
                             streams_of_instance * static_cast<std::uint32_t>(instance));
    bool const is_missing = random.uniform() < model.missing, has_wrong = random.uniform() < model.wrong;
    std::vector<bop::Detection> boxes;
    auto const add = [&](bop::ImageBox const& box, double mean) {
        bop::ImageBox const seen = disturbed(box, model, random);
        boxes.push_back({target.image, target.obj_id, seen, confidence(mean, random), -1});
    };
    if (!is_missing)
        add(truth, right_confidence);
    if (has_wrong && !others.empty())
        add(others[random.below(static_cast<std::uint32_t>(others.size()))], wrong_confidence);
    return boxes;
}

}  // namespace faster::experiments
