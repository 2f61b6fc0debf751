#include "tb/budget_run.hpp"

#include <filesystem>

#include "budgets/configuration_hash.hpp"
#include "budgets/run_figures.hpp"
#include "common/input_error.hpp"
#include "config/load_config.hpp"
#include "config/resolved_config.hpp"
#include "report/text_report.hpp"
#include "simulation/simulate.hpp"
#include "tb/workload_source.hpp"

namespace faster {

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
    measurement.clock_mhz = loaded.config.accelerator.clock_mhz;
    measurement.configuration = budgets::configuration_hash(keys);
    measurement.accelerator = budgets::accelerator_settings(keys);
    if (run.deadlocked()) {
        measurement.kind = Kind::deadlock;
        measurement.message = report::deadlock_report(run);
    } else if (std::string const left = leftover_tokens(run); !left.empty()) {
        measurement.kind = Kind::error;
        measurement.message = "tokens are left at the end of the run: " + left;
    } else {
        measurement.figures = budgets::run_figures(run, loaded.config.accelerator);
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
        Stimulus const stimulus = load_stimulus(loaded);
        return measurement_of(loaded, simulate(loaded.config.accelerator, stimulus, loaded.config.simulation.engine));
    } catch (InputError const& error) {
        return failed(Kind::bad_input, error.what());
    } catch (std::exception const& error) {
        return failed(Kind::error, std::string("unexpected error: ") + error.what());
    }
}

}  // namespace faster
