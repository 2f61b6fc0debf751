#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "poses/judging/scores.hpp"

namespace faster::poses {

/// What a score may be as well, going by the images at hand.
struct Interval {
    double value = 0;
    double low = 0;
    double high = 0;
};

/// `count` times as many images as there are, drawn with replacement: how often each was drawn. The generator is
/// Random (std::mt19937_64); a draw is floor(uniform * images). The same on every machine.
std::vector<ImageWeights> drawn_images(std::size_t images, std::size_t count, std::uint64_t seed);

/// The middle 95 % of `replicates` around `value`: their quantiles 0.025 and 0.975, linear between order statistics
/// (type 7 of Hyndman and Fan, 1996), and the value itself, should it be outside. Replicates that are NaN are left out;
/// without any, the value stands alone.
Interval interval_of(double value, std::vector<double> replicates);

}  // namespace faster::poses
