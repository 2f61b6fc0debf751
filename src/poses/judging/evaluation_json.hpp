#pragma once
#include <string>

#include "dataflow/base/json.hpp"
#include "faster/dataflow_names.hpp"
#include "poses/judging/evaluation.hpp"

namespace faster::poses {

/// Everything about an evaluation but the errors of single instances: evaluation.json.
Json evaluation_json(Evaluation const& evaluation);

/// An evaluation as a page for the browser, with its curves.
std::string evaluation_html(Evaluation const& evaluation);

}  // namespace faster::poses
