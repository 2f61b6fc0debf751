#pragma once
#include <string>

#include "kernel/base/json.hpp"
#include "poses/evaluation.hpp"

namespace faster::poses {

/// Everything about an evaluation but the errors of single instances: evaluation.json.
Json evaluation_json(Evaluation const& evaluation);

/// The same as a page for the browser, with its curves.
std::string evaluation_html(Evaluation const& evaluation);

}  // namespace faster::poses
