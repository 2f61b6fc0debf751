#include "kernel/compare/read_run.hpp"

#include <utility>

#include "kernel/base/input_error.hpp"
#include "kernel/base/program_name.hpp"
#include "kernel/compare/json_section.hpp"
#include "kernel/compare/summary_file.hpp"
#include "kernel/compare/table_files.hpp"

namespace faster::runs {

RunRecord read_run(std::filesystem::path const& folder) {
    std::error_code ignored;
    if (!std::filesystem::is_directory(folder, ignored))
        throw InputError(folder.string() + ": no such folder, expected the output of " + program_name() + " run --out");
    std::filesystem::path const file = folder / "summary.json";
    Json const document = parse_summary(file);
    JsonSection const summary(file.string(), "", document);
    RunRecord run = read_summary(summary);
    run.folder = folder.string();
    run.samples = read_samples(folder / "samples.csv", run, summary.integer("samples"));
    check_fifos(folder / "fifos.csv", run);
    check_loops(folder / "loops.csv", run);
    return run;
}

RunRecord run_record(std::string const& name, std::string const& summary, std::vector<SampleStatistics> samples) {
    Json const document = Json::parse(summary);
    RunRecord run = read_summary(JsonSection(name, "", document));
    run.folder = name;
    run.samples = std::move(samples);
    return run;
}

}  // namespace faster::runs
