#pragma once
#include <string>
#include <vector>

#include "dataflow/tools/sweeps/manifest.hpp"
#include "dataflow/tools/sweeps/point_result.hpp"

namespace dataflow::sweeps {

/// Columns of results.csv beside those of the manifest. No overlay may have such a name.
std::vector<std::string> const& result_columns();

/// results.csv (docs/formats.md): the points that have a result, in their order. Quotes as in RFC 4180.
std::string results_csv(Manifest const& manifest, Results const& results);

}  // namespace dataflow::sweeps
