#pragma once
#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "dataflow/base/files/append_file.hpp"
#include "dataflow/base/json.hpp"
#include "faster/data/mesh.hpp"
#include "faster/dataflow_names.hpp"

namespace faster::experiments {

/// What came of one method's look at one object.
struct EstimateResult {
    Pose pose;
    double weight = 0;
    double truth_weight = 0;      ///< of the true pose: if it is more, the search failed, not the score
    std::string verdict;          ///< found, weak, no_readings
    double seconds = 0;           ///< of the host
    std::vector<double> adds_mm;  ///< ADD-S of the heaviest sample so far, per iteration
};

Json to_json(EstimateResult const& result);
/// Throws Json::exception for anything else.
EstimateResult estimate_result_from_json(Json const& json);

/// Results as they come, by the hash of all that decides about them; so what is there is good for any experiment.
class EstimateJournal {
  public:
    /// Throws InputError if it cannot be written.
    explicit EstimateJournal(std::filesystem::path const& path);

    /// Null if there is none.
    EstimateResult const* find(std::string const& id) const;
    std::size_t damaged() const { return damaged_; }
    /// Is on the disk when the call returns.
    void append(std::string const& id, EstimateResult const& result);

  private:
    std::map<std::string, EstimateResult> results_;
    std::size_t damaged_;
    io::AppendFile file_;
};

}  // namespace faster::experiments
