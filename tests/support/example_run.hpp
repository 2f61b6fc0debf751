#pragma once
#include <string>
#include <vector>

#include "dataflow/run/config/resolved_config.hpp"
#include "dataflow/run/figures/run_statistics.hpp"
#include "dataflow/run/figures/sample_timeline.hpp"
#include "dataflow/tools/report/html/packed_timeline.hpp"
#include "faster/dataflow_names.hpp"

namespace faster::test {

/// A name that ends a script element, opens others and tries every quote.
std::string const hostile_text = R"(a"'`</script><img src=x onerror="document.title='stolen'"><!--&amp;\u003c)";

/// A run of two cores and five samples with figures as a real one has them, made up by hand.
RunStatistics example_run();

/// What the modules do during a sample: clear, triangles, sweep, with stalls inside and tokens in the FIFOs.
SampleTimeline example_timeline(std::uint64_t core, std::uint64_t sample, Cycles begin);
/// As a page holds it, with all its bars.
report::PackedTimeline packed_example_timeline(std::uint64_t core, std::uint64_t sample, Cycles begin);

/// Every key, with a hostile file name among those that are not default.
std::vector<ResolvedKey> example_keys();

}  // namespace faster::test
