#pragma once
#include "faster/data/stimulus.hpp"

namespace faster {

/// Counters and pictures of one sample: what model and reference must agree on, bit for bit.
struct SampleScore {
    SampleCounters counters;
    SampleMaps maps;
};

}  // namespace faster
