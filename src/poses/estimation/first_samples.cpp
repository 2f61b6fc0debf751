#include "poses/estimation/first_samples.hpp"

#include <algorithm>
#include <cmath>

#include "poses/estimation/streams.hpp"

namespace faster::estimation {

namespace {

constexpr int most_attempts = 64;
constexpr double box_slack = 1.5;

/// Of the image, where no box says more.
DetectionConfig whole_image(Camera const& camera) {
    return {0, 0, static_cast<double>(camera.width), static_cast<double>(camera.height), 0};
}

double sum_of_confidences(std::vector<DetectionConfig> const& boxes) {
    double sum = 0;
    for (DetectionConfig const& box : boxes)
        sum += box.confidence;
    return sum;
}

/// In proportion to their confidences; all alike if these are 0.
std::size_t drawn_box(std::vector<DetectionConfig> const& boxes, CounterRandom& random) {
    double const sum = sum_of_confidences(boxes);
    double place = random.uniform() * (sum > 0 ? sum : static_cast<double>(boxes.size()));
    for (std::size_t i = 0; i + 1 < boxes.size(); ++i) {
        place -= sum > 0 ? boxes[i].confidence : 1;
        if (place < 0)
            return i;
    }
    return boxes.size() - 1;
}

struct ImagePoint {
    double col;
    double row;
};

ImagePoint point_in(DetectionConfig const& box, CounterRandom& random) {
    auto const share = [&random] {
        double const first = random.uniform();
        return (first + random.uniform()) / 2;
    };
    double const col = box.left + box.width * share();
    return {col, box.top + box.height * share()};
}

class FirstSamples {
  public:
    explicit FirstSamples(Scene const& scene)
        : scene_(scene),
          camera_(scene.observed.posed.camera),
          boxes_(scene.boxes.empty() ? std::vector<DetectionConfig>{whole_image(camera_)} : scene.boxes) {
        for (DetectionConfig const& box : boxes_)
            has_readings_.push_back(readings_in(box, scene.observed.observed_depth) > 0);
    }

    Particle draw(CounterRandom random) const {
        Particle particle;
        particle.box = drawn_box(boxes_, random);
        ImagePoint const centre = point_in(boxes_[particle.box], random);
        double const z = depth_in(particle.box, random);
        particle.middle = {(centre.col - camera_.cx) / camera_.fx * z, (centre.row - camera_.cy) / camera_.fy * z, z};
        particle.rotation = uniform_rotation(random);
        return particle;
    }

  private:
    double depth_in(std::size_t number, CounterRandom& random) const {
        DetectionConfig const& box = boxes_[number];
        double const filling = filling_depth(box);
        double const farthest = scene_.boxes.empty() ? 4 : box_slack * filling;
        for (int attempt = 0; has_readings_[number] && attempt < most_attempts; ++attempt) {
            double const reading = reading_at(point_in(box, random));
            double const extent =
                scene_.size.least_extent + (scene_.size.diameter - scene_.size.least_extent) * random.uniform();
            double const depth = reading + extent / 2;
            if (reading > 0 && depth <= farthest)
                return depth;
        }
        return filling;
    }

    /// At which the object's diameter is as long as the box's longer side.
    double filling_depth(DetectionConfig const& box) const {
        double const longest = std::max({box.width / camera_.fx, box.height / camera_.fy, 1e-3});
        return std::max(0.1, scene_.size.diameter / longest);
    }

    /// [m], the middle of its code; 0 where there is none.
    double reading_at(ImagePoint const& point) const {
        Image<std::uint16_t> const& depth = scene_.observed.observed_depth;
        double const row = std::floor(point.row), col = std::floor(point.col);
        if (!(row >= 0 && col >= 0 && row < depth.height() && col < depth.width()))
            return 0;
        int const code = depth.at(static_cast<int>(row), static_cast<int>(col));
        return code == 0 ? 0 : std::ldexp(code + 0.5, -scene_.observed.fraction.depth_buffer);
    }

    Scene const& scene_;
    Camera camera_;
    std::vector<DetectionConfig> boxes_;
    std::vector<bool> has_readings_;
};

}  // namespace

std::vector<Particle> first_samples(Scene const& scene, std::size_t count, std::uint64_t seed) {
    FirstSamples const samples(scene);
    std::vector<Particle> particles;
    for (std::size_t i = 0; i < count; ++i)
        particles.push_back(samples.draw(stream_of_sample(seed, 0, i)));
    return particles;
}

}  // namespace faster::estimation
