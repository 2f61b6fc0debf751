#pragma once
#include <cstddef>

#include "faster/config/accelerator_config.hpp"
#include "faster/data/stimulus.hpp"

namespace faster::testing {

inline AcceleratorConfig with_cores(std::uint64_t cores) {
    AcceleratorConfig config;
    config.cores = cores;
    return config;
}

/// `samples` samples without triangles around pixel (W/2, W/2), so that window and image coordinates are the same.
/// Observed: 1 m and an edge everywhere.
inline Stimulus empty_stimulus(int window, int samples) {
    Stimulus stimulus;
    stimulus.width = 2 * window;
    stimulus.height = 2 * window;
    stimulus.window = window;
    stimulus.observed_depth = Image<std::uint16_t>(stimulus.height, stimulus.width, 512);
    stimulus.observed_edges = Image<std::uint8_t>(stimulus.height, stimulus.width, 1);
    SampleInput sample;
    sample.centre_row = window / 2;
    sample.centre_col = window / 2;
    stimulus.samples.assign(static_cast<std::size_t>(samples), sample);
    return stimulus;
}

/// One sample, window 4, one triangle at 1 m with corners at pixels (row, col) (1, 1), (2, 1), (1, 2). The unit test of
/// the cycle twin works it out token by token.
inline Stimulus one_small_triangle() {
    Stimulus stimulus = empty_stimulus(4, 1);
    constexpr std::uint16_t metre = 1U << 14;
    stimulus.triangles.push_back({{{16, 16, metre}, {16, 32, metre}, {32, 16, metre}}});
    stimulus.samples[0].triangle_count = 1;
    return stimulus;
}

}  // namespace faster::testing
