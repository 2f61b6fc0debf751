#pragma once
#include <string>
#include <vector>

#include "kernel/figures/diagnosis.hpp"

namespace faster::report {

/// What a run is bound by, a sentence each, the largest cause first; causes below 1 % are left out.
std::vector<std::string> diagnosis_sentences(RunStatistics const& run);

}  // namespace faster::report
