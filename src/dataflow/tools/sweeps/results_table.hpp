#pragma once
#include <string>
#include <vector>

#include "dataflow/tools/sweeps/manifest.hpp"
#include "dataflow/tools/sweeps/point_result.hpp"

namespace dataflow::sweeps {

/// Columns of results.csv beside those of the manifest. No overlay may have such a name.
std::vector<std::string> const& result_columns();

struct PointWithResult {
    std::size_t point;  ///< of the manifest
    PointResult const& result;
};
/// Points that have no result are left out. In the manifest's order; they refer to `results`.
std::vector<PointWithResult> points_with_results(Manifest const& manifest, Results const& results);

/// results.csv (docs/formats.md): the points that have a result, in their order. Quotes as in RFC 4180.
std::string results_csv(Manifest const& manifest, Results const& results);

}  // namespace dataflow::sweeps
