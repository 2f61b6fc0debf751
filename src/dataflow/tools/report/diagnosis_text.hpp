#pragma once
#include <string>
#include <vector>

#include "dataflow/run/figures/diagnosis.hpp"

namespace dataflow::report {

/// What a run is bound by, a sentence each, the largest cause first; causes below 1 % are left out.
std::vector<std::string> diagnosis_sentences(RunStatistics const& run);

}  // namespace dataflow::report
