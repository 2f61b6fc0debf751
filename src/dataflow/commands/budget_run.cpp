#include "dataflow/commands/budget_run.hpp"

#include <algorithm>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <fmt/chrono.h>
#include <fmt/format.h>

#include "dataflow/base/input_error.hpp"
#include "dataflow/commands/progress_line.hpp"
#include "dataflow/commands/simulated_run.hpp"
#include "dataflow/run/config/load_config.hpp"
#include "dataflow/run/config/resolved_config.hpp"
#include "dataflow/tools/budgets/figures.hpp"
#include "dataflow/tools/budgets/measurement.hpp"
#include "dataflow/tools/report/text_report.hpp"

namespace dataflow {

namespace {

using Kind = budgets::Measurement::Kind;

std::vector<std::string> all_overrides(budgets::Budget const& budget, std::vector<std::string> const& more) {
    std::vector<std::string> overrides = budget.overrides;
    overrides.insert(overrides.end(), more.begin(), more.end());
    if (!budget.trace.empty())
        overrides.push_back("workload.trace=" + budget.trace);
    return overrides;
}

/// Relative paths in the configuration then read the same wherever the caller stands, and so does its hash.
void enter_folder_of(std::filesystem::path const& file) {
    if (file.has_parent_path())
        std::filesystem::current_path(file.parent_path());
}

budgets::Measurement measurement_of(LoadedConfig const& loaded, RunStatistics const& run) {
    std::vector<ResolvedKey> const keys = resolved_keys(loaded.config);
    budgets::Measurement measurement;
    measurement.clock_mhz = run.machine.clock_mhz;
    measurement.configuration = configuration_hash(keys);
    measurement.accelerator = budgets::accelerator_settings(keys);
    if (run.deadlocked()) {
        measurement.kind = Kind::deadlock;
        measurement.message = report::deadlock_report(run);
    } else if (std::string const left = leftover_tokens(run); !left.empty()) {
        measurement.kind = Kind::error;
        measurement.message = "tokens are left at the end of the run: " + left;
    } else {
        measurement.figures = budgets::run_figures(run);
    }
    return measurement;
}

budgets::Measurement failed(Kind kind, std::string const& message) {
    budgets::Measurement measurement;
    measurement.kind = kind;
    measurement.message = message;
    return measurement;
}

}  // namespace

budgets::Measurement measure(budgets::Budget const& budget, std::vector<std::string> const& overrides) {
    try {
        enter_folder_of(budget.file);
        LoadedConfig loaded = load_config(budget.configuration, all_overrides(budget, overrides));
        RunStatistics const run = simulate(loaded);
        return measurement_of(loaded, run);
    } catch (InputError const& error) {
        return failed(Kind::bad_input, error.what());
    } catch (std::exception const& error) {
        return failed(Kind::error, std::string("unexpected error: ") + error.what());
    }
}

std::vector<processes::Outcome> run_budgets(std::vector<budgets::Budget> const& budgets,
                                            std::vector<std::string> const& overrides, CheckRequest const& request,
                                            processes::SignalWatch const& watch) {
    std::vector<processes::Task> tasks;
    tasks.reserve(budgets.size());
    for (budgets::Budget const& budget : budgets)
        tasks.push_back(
            {[&budget, &overrides] { return to_text(measure(budget, overrides)); }, time_limit_of(budget, request)});
    ProgressLine progress("budgets");
    return processes::run_all(tasks, static_cast<std::size_t>(request.jobs), watch, progress.teller());
}

double time_limit_of(budgets::Budget const& budget, CheckRequest const& request) {
    return request.time_limit_s > 0 ? request.time_limit_s : budget.time_limit_s;
}

std::string why_no_result(processes::Outcome const& outcome, double time_limit_s, std::string_view limit) {
    using End = processes::Outcome::Kind;
    if (outcome.kind == End::timed_out)
        return fmt::format("no result after {:g} s, the simulation was ended ({})", time_limit_s, limit);
    if (outcome.kind == End::crashed)
        return fmt::format("the simulation was ended by signal {} ({})", outcome.signal, strsignal(outcome.signal));
    return fmt::format("the simulation ended with exit code {} and no result", outcome.exit_code);
}

std::string today() { return fmt::format("{:%Y-%m-%d}", fmt::gmtime(std::time(nullptr))); }

}  // namespace dataflow
