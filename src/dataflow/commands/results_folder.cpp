#include "dataflow/commands/results_folder.hpp"

#include "dataflow/base/files/text_file.hpp"
#include "dataflow/run/config/design.hpp"
#include "dataflow/run/config/resolved_config.hpp"
#include "dataflow/tools/report/csv.hpp"
#include "dataflow/tools/report/provenance.hpp"
#include "dataflow/tools/report/sensitivity_report.hpp"

namespace dataflow {

namespace fs = std::filesystem;

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
        std::string const begin = R"(id="data">{"format":")";
        return io::FolderKind{"run's results",  "summary.json", others,
                              "faster-summary", "report.html",  {begin + "faster-report", begin + "faster-deadlock"}};
    }();
    return results_folder;
}

/// The page that the run itself writes takes the place of the older one later, and keeps its rights.
io::FolderKind ResultsFolder::kind_beside(fs::path const& folder, fs::path const& report) {
    io::FolderKind folder_kind = kind();
    std::error_code ignored;
    if (!report.empty() && fs::equivalent(folder / folder_kind.page, report, ignored))
        folder_kind.page.clear();
    return folder_kind;
}

ResultsFolder::ResultsFolder(fs::path const& folder, fs::path const& report)
    : folder_(folder, kind_beside(folder, report)) {}

void ResultsFolder::write(RunConfig const& config, RunStatistics const& run, report::HostTime const& host,
                          std::string const& workload_table,
                          std::function<void(std::filesystem::path const&)> const& write_pictures) {
    std::vector<ResolvedKey> const keys = resolved_keys(config);
    io::write_file(folder_.path() / "summary.json", report::summary_json(keys, run, host, report::made_by_json(keys)));
    io::write_file(folder_.path() / "samples.csv", report::samples_csv(run, config));
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
