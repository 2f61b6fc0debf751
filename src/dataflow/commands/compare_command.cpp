#include <cstdint>
#include <string>

#include "dataflow/base/files/output_file.hpp"
#include "dataflow/commands/command_paths.hpp"
#include "dataflow/commands/exit_codes.hpp"
#include "dataflow/commands/options.hpp"
#include "dataflow/commands/results_folder.hpp"
#include "dataflow/commands/say.hpp"
#include "dataflow/commands/standard_commands.hpp"
#include "dataflow/tools/compare/compare.hpp"
#include "dataflow/tools/compare/comparison_report.hpp"
#include "dataflow/tools/compare/read_run.hpp"

namespace dataflow {

namespace {

/// `faster-sim compare`.
struct CompareRequest {
    std::string run_a;      ///< output folder of a run
    std::string run_b;      ///< and of another
    std::int64_t top = 10;  ///< rows per list
    std::string json;       ///< file; empty: print only
};

/// Returns exit_failed_check if the runs have other samples or score one differently, and exit_done if nothing but time
/// differs. Throws InputError on bad input.
int compare(CompareRequest const& request) {
    CommandPaths paths;
    paths.reads(request.run_a, ResultsFolder::kind());
    paths.reads(request.run_b, ResultsFolder::kind());
    paths.writes("--json", request.json);
    auto const json = io::optional_output_file(request.json);
    runs::Comparison const comparison = runs::compare(runs::read_run(request.run_a), runs::read_run(request.run_b));
    if (json)
        json->commit(runs::comparison_json(comparison));
    say("{}", runs::comparison_text(comparison, static_cast<std::size_t>(request.top)));
    say_written({request.json});
    return comparison.is_functionally_equal() ? exit_done : exit_failed_check;
}

}  // namespace

Subcommand compare_command() {
    return {
        "compare", "Say what changed from one run to another, largest first", [](CLI::App& command) {
            auto const request = std::make_shared<CompareRequest>();
            command.add_option("run_a", request->run_a, "Output folder of a run")->required()->type_name("RUN_A");
            command.add_option("run_b", request->run_b, "Output folder of another run")->required()->type_name("RUN_B");
            command.add_option("--top", request->top, "Rows of each list; the others are counted")
                ->type_name("N")
                ->capture_default_str()
                ->check(integer_in(0, 1000000));
            command.add_option("--json", request->json, "Write the whole comparison to this file")->type_name("FILE");
            return [request] { return compare(*request); };
        }};
}

}  // namespace dataflow
