#pragma once
#include <filesystem>
#include <functional>

#include "dataflow/base/files/atomic_folder.hpp"
#include "dataflow/run/config/run_config.hpp"
#include "dataflow/run/figures/run_statistics.hpp"
#include "dataflow/tools/report/summary.hpp"

namespace dataflow {

/// The output folder of `run --out` and `whatif --out` (docs/formats.md#output-of-a-run).
class ResultsFolder {
  public:
    /// Throws InputError if it cannot be written: before the work whose results would be lost. `report`: the page that
    /// the run writes besides; empty: none.
    explicit ResultsFolder(std::filesystem::path const& folder, std::filesystem::path const& report = {});
    static io::FolderKind const& kind();

    /// Where to write a file that is to be at `file` when all is written, see AtomicFolder.
    std::filesystem::path place_of(std::filesystem::path const& file) { return folder_.place_of(file); }

    /// Writes all files; `workload_table` of Workload::table(), may be empty. `write_pictures` may put images into the
    /// folder it is given, and be empty.
    void write(RunConfig const& config, RunStatistics const& run, report::HostTime const& host,
               std::string const& workload_table = {},
               std::function<void(std::filesystem::path const& images)> const& write_pictures = {});
    /// Only who waits for whom: nobody should take the rest for results.
    void write_deadlock(RunConfig const& config, RunStatistics const& run);

  private:
    static io::FolderKind kind_beside(std::filesystem::path const& folder, std::filesystem::path const& report);

    io::AtomicFolder folder_;
};

}  // namespace dataflow
