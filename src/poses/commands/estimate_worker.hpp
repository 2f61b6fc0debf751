#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "dataflow/base/process_pool.hpp"
#include "dataflow/commands/work_size.hpp"
#include "faster/dataflow_names.hpp"
#include "poses/commands/experiment_estimates.hpp"
#include "poses/experiments/estimate_journal.hpp"

namespace faster {

/// A new or empty folder, or one with a journal of estimates; throws InputError for another, saying `kind`.
void take_folder_of_estimates(std::filesystem::path const& folder, std::string const& kind);

/// The journal's file in such a folder.
constexpr char const* journal_of_estimates = "journal";

/// Does the estimates that a journal does not have, in processes of their own, and writes each into it as it comes.
class EstimateWorker {
  public:
    /// Both must outlive it.
    EstimateWorker(std::vector<WantedEstimate> const& wanted, experiments::EstimateJournal& journal);

    std::size_t pending() const { return pending_.size(); }
    std::size_t failed() const { return failed_; }
    WorkSize size(char const* command, std::size_t jobs) const;
    /// Throws InputError for the first estimate that is of bad input; those that came before are in the journal.
    void work(std::size_t jobs, std::size_t all);

  private:
    void take(WantedEstimate const& wanted, processes::Outcome const& outcome);

    experiments::EstimateJournal& journal_;
    std::vector<WantedEstimate const*> pending_;
    std::size_t failed_ = 0;
};

/// The estimates of a method in a setting that are there, as results of BOP. Their times are not known.
std::string results_of(std::vector<WantedEstimate> const& wanted, experiments::EstimateJournal const& journal,
                       SettingData const& setting, MethodData const& method);

}  // namespace faster
