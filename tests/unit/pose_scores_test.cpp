#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "dataflow/base/random.hpp"
#include "faster/dataflow_names.hpp"
#include "poses/judging/bootstrap.hpp"
#include "poses/judging/judge.hpp"
#include "poses/judging/matching.hpp"
#include "poses/judging/scores.hpp"

namespace pose_scores_test {

using namespace faster::poses;
using faster::Random;

constexpr double inf = std::numeric_limits<double>::infinity();

/// VOCap of YCB-Video's plot_accuracy_keyframe.m, line by line, with its arrays.
double area_with_arrays(std::vector<double> errors) {
    for (double& error : errors)
        error = error > 0.1 ? inf : error;
    std::sort(errors.begin(), errors.end());
    std::vector<double> recall{0}, precision{0};
    for (std::size_t i = 0; i < errors.size(); ++i) {
        if (std::isfinite(errors[i])) {
            recall.push_back(errors[i]);
            precision.push_back(static_cast<double>(i + 1) / static_cast<double>(errors.size()));
        }
    }
    recall.push_back(0.1);
    precision.push_back(precision.back());
    for (std::size_t i = 1; i < precision.size(); ++i)
        precision[i] = std::max(precision[i], precision[i - 1]);
    double area = 0;
    for (std::size_t i = 1; i < recall.size(); ++i) {
        if (recall[i] != recall[i - 1])
            area += (recall[i] - recall[i - 1]) * precision[i];
    }
    return 10 * area;
}

double area_of(std::vector<double> errors) {
    std::sort(errors.begin(), errors.end());
    std::vector<WeightedError> finite;
    for (double const error : errors) {
        if (error <= 0.1)
            finite.push_back({error, 1});
    }
    return area_under_accuracy(finite, static_cast<double>(errors.size()));
}

InstanceErrors instance(int im_id, double add_m, double add_s_m, int hits) {
    return {{1, im_id}, 1, std::nullopt, add_m, add_s_m, add_m, hits, 0, hits / 2, 0.25};
}

TEST_CASE("The area under the curve of accuracy, by hand", "[pose_scores]") {
    CHECK(area_of({0, 0, 0}) == Approx(1));
    CHECK(area_of({0.02, 0.06}) == Approx(0.9));  // (0.02 x 1/2 + 0.04 x 1 + 0.04 x 1) x 10
    CHECK(area_of({0.06, 0.02}) == Approx(0.9));
    CHECK(area_of({0.02, inf}) == Approx(0.5));
    CHECK(area_of({0.05, 0.05}) == Approx(0.75));
    CHECK(area_of({0.05}) == Approx(1));  // the toolbox's curve has the height of the right end
    CHECK(area_of({0.1, 0.1, 0.1, 0.1}) == Approx(0.25));
    CHECK(area_of({0.1000001, inf}) == 0);
}

TEST_CASE("The area is that of the toolbox's arrays", "[pose_scores]") {
    auto const seed = static_cast<std::uint64_t>(GENERATE(range(1, 21)));
    CAPTURE(seed);
    Random random(seed);
    std::vector<double> errors;
    for (std::size_t count = 1 + seed * 3; errors.size() < count;) {
        double const error = std::round(150 * random.uniform()) / 1000;  // to a millimetre: many are equal
        errors.push_back(random.uniform() < 0.1 ? inf : error);
    }
    CHECK(area_of(errors) == Approx(area_with_arrays(errors)).margin(1e-12));
}

TEST_CASE("An error of weight three counts like three equal errors", "[pose_scores]") {
    std::vector<WeightedError> const weighted{{0.01, 0}, {0.02, 3}, {0.05, 1}, {0.07, 2}};
    CHECK(area_under_accuracy(weighted, 8) == Approx(area_of({0.02, 0.02, 0.02, 0.05, 0.07, 0.07, inf, inf})));
}

TEST_CASE("Scores by hand, with images that count several times or not at all", "[pose_scores]") {
    std::vector<InstanceErrors> const instances{instance(0, 0.05, 0.01, 8), instance(1, inf, inf, 0),
                                                instance(2, 0.02, 0.02, 10)};
    ScoredInstances const scored(instances, {0, 1, 2});
    Scores const once = scored.scores({1, 1, 1});
    CHECK(once[0] == Approx(100 * area_of({0.01, 0.02, inf})));
    CHECK(once[1] == Approx(100 * area_of({0.02, 0.05, inf})));
    CHECK(once[2] == Approx(100.0 / 3));  // 2 cm is not below 2 cm
    CHECK(once[3] == Approx(200.0 / 3));
    CHECK(once[4] == 0);
    CHECK(once[5] == Approx(100.0 / 3));
    CHECK(once[6] == Approx(60));
    CHECK(once[7] == Approx(100 * (0.9 + 0.8) / 3));  // plain areas
    CHECK(once[8] == Approx(100 * (0.5 + 0.8) / 3));
    CHECK(once[9] == Approx(30));
    CHECK(once[10] == Approx(25));
    CHECK(once[11] == Approx((60 + 30 + 25) / 3.0));
    Scores const drawn = scored.scores({3, 1, 0});
    CHECK(drawn[7] == Approx(100 * 3 * 0.9 / 4));
    CHECK(drawn[0] == Approx(drawn[7] + once[0] - once[7]));  // the toolbox's is more by as much as in all images
    CHECK(drawn[2] == Approx(75));
    CHECK(drawn[6] == Approx(100 * 24.0 / 40));
    CHECK(std::isnan(scored.scores({0, 0, 0})[0]));
}

TEST_CASE("Intervals of all areas surround their values", "[pose_scores]") {
    auto const seed = static_cast<std::uint64_t>(GENERATE(range(1, 11)));
    CAPTURE(seed);
    Random random(seed);
    std::vector<InstanceErrors> instances;
    std::vector<std::size_t> images;
    for (int i = 0; i < 2 + static_cast<int>(seed); ++i) {
        instances.push_back(instance(i, 0.12 * random.uniform(), 0.12 * random.uniform(), 3));
        images.push_back(static_cast<std::size_t>(i));
    }
    ScoredInstances const scored(instances, images);
    Scores const value = scored.scores(ImageWeights(images.size(), 1));
    for (std::size_t score = 0; score < score_count; ++score) {
        std::vector<double> replicates;
        for (ImageWeights const& draw : drawn_images(images.size(), 200, seed))
            replicates.push_back(scored.scores(draw)[score]);
        Interval const interval = interval_of(value[score], replicates);
        CAPTURE(score_facts[score].name);
        CHECK(interval.low <= value[score]);
        CHECK(value[score] <= interval.high);
        double mean = 0;
        for (double const replicate : replicates)
            mean += replicate / 200;
        CHECK(std::abs(mean - value[score]) < 12);  // a draw is no worse than the whole
    }
}

TEST_CASE("A single instance has the toolbox's whole area, however far off, and its own plain one", "[pose_scores]") {
    ScoredInstances const scored({instance(0, 0.037, 0.037, 0)}, {0});
    CHECK(scored.scores({1})[0] == Approx(100));
    CHECK(scored.scores({1})[7] == Approx(63));
    CHECK(scored.scores({2})[7] == Approx(63));
}

TEST_CASE("What is not known of an instance is not known of all", "[pose_scores]") {
    std::vector<InstanceErrors> instances{instance(0, 0.01, 0.01, 8), instance(1, 0.01, 0.01, 8)};
    instances[1].vsd_recall.reset();
    ScoredInstances const scored(instances, {0, 1});
    CHECK(std::isnan(scored.scores({1, 1})[10]));
    CHECK(std::isnan(scored.scores({1, 1})[11]));
    CHECK(scored.scores({1, 1})[6] == Approx(80));
    CHECK(scored.scores({1, 0})[10] == Approx(25));
}

TEST_CASE("Estimates take the nearest true pose that is left, the best score first", "[pose_scores]") {
    PairErrors const errors{{0.5, 0.2}, {0.9, 0.1}, {0.3, 0.3}};
    CHECK(matched_below(errors, 2, 1) == std::vector<double>{0.9, 0.2});
    CHECK(matched_below(errors, 2, 0.5) == std::vector<double>{0.3, 0.2});
    CHECK(matched_below(errors, 2, 0.2) == std::vector<double>{inf, 0.1});  // below, not at, the limit
    CHECK(matched(errors, 2, 0.2) == std::vector<double>{0.5, 0.1});        // and what is left, for the record
    CHECK(matched_below({}, 1, 1) == std::vector<double>{inf});
}

TEST_CASE("Images are drawn by a generator that is the same everywhere", "[pose_scores]") {
    auto const draws = drawn_images(7, 300, 5);
    std::mt19937_64 engine(5);
    for (ImageWeights const& weights : draws) {
        ImageWeights expected(7, 0);
        for (int i = 0; i < 7; ++i)
            expected[static_cast<std::size_t>(std::floor(7 * std::ldexp(static_cast<double>(engine() >> 11), -53)))] +=
                1;
        REQUIRE(weights == expected);
    }
    CHECK(drawn_images(7, 300, 6) != draws);
}

TEST_CASE("An interval is the middle 95 per cent", "[pose_scores]") {
    std::vector<double> replicates;
    for (int i = 40; i >= 0; --i)
        replicates.push_back(i);
    replicates.push_back(std::numeric_limits<double>::quiet_NaN());
    Interval const interval = interval_of(25, replicates);
    CHECK(interval.value == 25);
    CHECK(interval.low == Approx(1));
    CHECK(interval.high == Approx(39));
    CHECK(interval_of(3, {}).low == 3);
    CHECK(interval_of(3, {4}).high == 4);
    CHECK(interval_of(3, {4}).low == 3);  // it surrounds its value
    CHECK(interval_of(40.5, replicates).high == 40.5);
}

TEST_CASE("The interval of a share is as wide as the binomial distribution says", "[pose_scores]") {
    std::vector<InstanceErrors> instances;
    std::vector<std::size_t> images;
    for (int i = 0; i < 100; ++i) {
        instances.push_back(instance(i, i % 4 == 0 ? 0.001 : inf, inf, 0));
        images.push_back(static_cast<std::size_t>(i));
    }
    ScoredInstances const scored(instances, images);
    std::vector<double> replicates;
    for (ImageWeights const& draw : drawn_images(100, 2000, 1))
        replicates.push_back(scored.scores(draw)[4]);
    Interval const interval = interval_of(25, replicates);
    double const expected = 1.96 * std::sqrt(100 * 0.25 * 0.75);
    CHECK(interval.high - interval.low == Approx(2 * expected).epsilon(0.1));
}

}  // namespace pose_scores_test
