#pragma once
#include <string>
#include <vector>

#include "dataflow/base/json.hpp"
#include "dataflow/tools/sweeps/journal.hpp"
#include "faster/data/mesh.hpp"
#include "faster/dataflow_names.hpp"

namespace faster::experiments {

/// What came of one method's look at one object.
struct EstimateResult {
    static constexpr char const* journal_key = "estimate";  ///< see sweeps::Journal
    Pose pose;
    double weight = 0;
    double truth_weight = 0;      ///< of the true pose: if it is more, the search failed, not the score
    std::string verdict;          ///< found, weak, no_readings
    double seconds = 0;           ///< of the host
    std::vector<double> adds_mm;  ///< ADD-S of the heaviest sample so far, per iteration
};

Json to_json(EstimateResult const& result);
/// Throws Json::exception for anything else.
void from_json(Json const& json, EstimateResult& result);

/// By the hash of all that decides about an estimate; so what is there is good for any experiment.
using EstimateJournal = sweeps::Journal<EstimateResult>;

}  // namespace faster::experiments
