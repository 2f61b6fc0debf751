#pragma once
#include <string>
#include <vector>

#include "dataflow/base/json.hpp"
#include "dataflow/base/made_by.hpp"
#include "dataflow/run/config/resolved_config.hpp"

namespace dataflow::report {

/// Where a result comes from: program, version, commit, command and hash of the configuration with these keys. No date
/// of the run, so that equal runs write equal bytes.
Json made_by_json(std::vector<ResolvedKey> const& keys);

/// Where a result comes from, as a line of HTML. An empty hash is left out.
std::string made_by_html(std::string const& configuration_hash, MadeBy const& maker = made_by());

}  // namespace dataflow::report
