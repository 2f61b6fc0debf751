#pragma once
#include <vector>

#include "kernel/base/json.hpp"
#include "kernel/config/resolved_config.hpp"

namespace faster::report {

/// All keys as pages show them. Values as text: JavaScript's numbers would round the larger integers.
Json configuration_data(std::vector<ResolvedKey> const& keys);

}  // namespace faster::report
