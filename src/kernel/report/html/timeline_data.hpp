#pragma once
#include "kernel/base/json.hpp"
#include "kernel/figures/sample_timeline.hpp"
#include "kernel/machine/machine.hpp"

namespace faster::report {

/// A sample's timeline as pages draw it: with as many bars and points as a wide screen can show.
Json timeline_data(Machine const& machine, SampleTimeline const& timeline);

}  // namespace faster::report
