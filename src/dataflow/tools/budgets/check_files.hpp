#pragma once
#include <string>
#include <vector>

#include "dataflow/tools/budgets/check_result.hpp"

namespace dataflow::budgets {

/// All results as a JSON file (docs/formats.md, "Results of a check").
std::string check_json(std::vector<CheckResult> const& results);

/// All results in the JUnit format that CI services read: a test suite per budget, a test case per limit. A breach is
/// a failure; a run without figures is one case `simulation`, a failure if it deadlocked and an error otherwise.
std::string junit_xml(std::vector<CheckResult> const& results);

/// Text as XML has it between tags and in attributes; control characters that XML 1.0 forbids become `?`.
std::string xml_text(std::string const& text);

}  // namespace dataflow::budgets
