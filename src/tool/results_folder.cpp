#include "tool/results_folder.hpp"

#include "kernel/base/files/text_file.hpp"
#include "kernel/config/resolved_config.hpp"
#include "kernel/report/csv.hpp"
#include "kernel/report/sensitivity_report.hpp"

namespace faster {

namespace {
io::FolderKind const results_folder{
    "run's results", "summary.json", {"samples.csv", "fifos.csv", "loops.csv", "sensitivities.csv", "images"}};
}  // namespace

io::FolderKind const& ResultsFolder::kind() { return results_folder; }

ResultsFolder::ResultsFolder(std::filesystem::path const& folder) : folder_(folder, results_folder) {}

void ResultsFolder::write(RunConfig const& config, RunStatistics const& run, report::HostTime const& host,
                          std::function<void(std::filesystem::path const&)> const& write_pictures) {
    io::write_file(folder_.path() / "summary.json", report::summary_json(resolved_keys(config), run, host));
    io::write_file(folder_.path() / "samples.csv", report::samples_csv(run));
    io::write_file(folder_.path() / "fifos.csv", report::fifos_csv(run));
    io::write_file(folder_.path() / "loops.csv", report::loops_csv(run));
    if (!run.sensitivities.empty())
        io::write_file(folder_.path() / "sensitivities.csv", report::sensitivities_csv(run));
    if (write_pictures)
        write_pictures(folder_.path() / "images");
    folder_.commit();
}

void ResultsFolder::write_deadlock(RunConfig const& config, RunStatistics const& run) {
    io::write_file(folder_.path() / "summary.json", report::deadlock_summary_json(resolved_keys(config), run));
    folder_.commit();
}

}  // namespace faster
