#include "dataflow/commands/results_folder.hpp"

#include "dataflow/base/files/text_file.hpp"
#include "dataflow/run/config/design.hpp"
#include "dataflow/run/config/resolved_config.hpp"
#include "dataflow/tools/report/csv.hpp"
#include "dataflow/tools/report/provenance.hpp"
#include "dataflow/tools/report/sensitivity_report.hpp"

namespace dataflow {

io::FolderKind const& ResultsFolder::kind() {
    static io::FolderKind const results_folder = [] {
        std::vector<std::string> others{"samples.csv",
                                        "fifos.csv",
                                        "loops.csv",
                                        "all_loops.csv",
                                        "sensitivities.csv",
                                        "images/sample_*.png",
                                        "images/contact_sheet.png"};
        if (std::string const table = design().workload_table(); !table.empty())
            others.push_back(table);
        return io::FolderKind{"run's results", "summary.json", others, "faster-summary"};
    }();
    return results_folder;
}

ResultsFolder::ResultsFolder(std::filesystem::path const& folder) : folder_(folder, kind()) {}

void ResultsFolder::write(RunConfig const& config, RunStatistics const& run, report::HostTime const& host,
                          std::string const& workload_table,
                          std::function<void(std::filesystem::path const&)> const& write_pictures) {
    std::vector<ResolvedKey> const keys = resolved_keys(config);
    io::write_file(folder_.path() / "summary.json", report::summary_json(keys, run, host, report::made_by_json(keys)));
    io::write_file(folder_.path() / "samples.csv", report::samples_csv(run));
    io::write_file(folder_.path() / "fifos.csv", report::fifos_csv(run));
    io::write_file(folder_.path() / "loops.csv", report::loops_csv(run));
    io::write_file(folder_.path() / "all_loops.csv", report::all_loops_csv(run));
    if (!workload_table.empty())
        io::write_file(folder_.path() / design().workload_table(), workload_table);
    if (!run.sensitivities.empty())
        io::write_file(folder_.path() / "sensitivities.csv", report::sensitivities_csv(run));
    if (write_pictures)
        write_pictures(folder_.path() / "images");
    folder_.commit();
}

void ResultsFolder::write_deadlock(RunConfig const& config, RunStatistics const& run) {
    std::vector<ResolvedKey> const keys = resolved_keys(config);
    io::write_file(folder_.path() / "summary.json",
                   report::deadlock_summary_json(keys, run, report::made_by_json(keys)));
    folder_.commit();
}

}  // namespace dataflow
