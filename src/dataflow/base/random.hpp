#pragma once
#include <cmath>
#include <cstdint>
#include <random>

#include "dataflow/base/portable_math.hpp"

namespace dataflow {

/// Seeded random numbers that are the same with every compiler and library: the engine is fixed by the standard, the
/// distributions, which the standard leaves open, are written here. Each call takes a fixed number of engine outputs,
/// so draws that come later do not depend on values drawn before.
class Random {
  public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}

    /// Uniform in [0, 1), a multiple of 2^-53.
    double uniform() { return 0x1p-53 * static_cast<double>(engine_() >> 11); }

    /// Standard normal, by Box and Muller; the second value of the pair is dropped.
    double normal() { return normal_draw().value(); }
    /// One that may turn out not to be wanted: its logarithm and cosine take ten times as long as the draw.
    struct NormalDraw {
        double for_radius, for_angle;
        double value() const {
            return std::sqrt(-2 * std::log(1 - for_radius)) * std::cos(2 * portable::pi * for_angle);
        }
    };
    NormalDraw normal_draw() {
        double const for_radius = uniform();
        return {for_radius, uniform()};
    }

  private:
    std::mt19937_64 engine_;
};

}  // namespace dataflow
