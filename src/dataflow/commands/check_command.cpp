#include "dataflow/commands/check_command.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <set>

#include "dataflow/base/files/output_file.hpp"
#include "dataflow/base/files/scratch.hpp"
#include "dataflow/base/files/text_file.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/base/process_pool.hpp"
#include "dataflow/base/program_name.hpp"
#include "dataflow/base/utf8.hpp"
#include "dataflow/commands/budget_run.hpp"
#include "dataflow/commands/command_paths.hpp"
#include "dataflow/commands/exit_codes.hpp"
#include "dataflow/commands/options.hpp"
#include "dataflow/commands/say.hpp"
#include "dataflow/run/config/design.hpp"
#include "dataflow/run/config/keys.hpp"
#include "dataflow/run/config/load_config.hpp"
#include "dataflow/tools/budgets/baseline_text.hpp"
#include "dataflow/tools/budgets/budget_file.hpp"
#include "dataflow/tools/budgets/check_files.hpp"
#include "dataflow/tools/budgets/check_text.hpp"
#include "dataflow/tools/budgets/replace_baseline.hpp"
#include "dataflow/tools/budgets/starting_budget.hpp"

namespace dataflow {

namespace {

namespace fs = std::filesystem;
using budgets::Budget;
using budgets::Measurement;
using processes::Outcome;

/// How a file in `folder` names a path that the caller gives relative to the current folder.
std::string seen_from(fs::path const& folder, std::string const& path) {
    if (path.empty() || fs::path(path).is_absolute())
        return path;
    return fs::weakly_canonical(fs::absolute(path)).lexically_relative(fs::weakly_canonical(folder)).string();
}

/// Of several settings of one key the last, which wins: a budget says each key once.
std::vector<std::string> last_of_each_key(std::vector<std::string> const& overrides) {
    std::vector<std::string> last;
    for (std::string const& setting : overrides) {
        std::string const key = setting.substr(0, setting.find('=') + 1);
        last.erase(std::remove_if(last.begin(), last.end(),
                                  [&](std::string const& other) { return other.rfind(key, 0) == 0; }),
                   last.end());
        last.push_back(setting);
    }
    return last;
}

Budget new_budget(CheckRequest const& request) {
    Budget budget;
    budget.file = request.out.empty() ? fs::path(request.init).stem().string() + ".budget.yaml" : request.out;
    if (fs::exists(budget.file))
        throw InputError(budget.file.string() + ": is there already, expected a new file (--out FILE)");
    fs::path const folder = fs::absolute(budget.file).parent_path();
    budget.configuration = seen_from(folder, request.init);
    budget.trace = seen_from(folder, request.trace);
    budget.overrides = last_of_each_key(request.overrides);
    return budget;
}

/// The module that makes the results: it writes what the one that ends samples reads.
budgets::GuardedFigures guarded_figures(Machine const& machine) {
    std::size_t module = machine.ends;
    for (MachineFifo const& fifo : machine.fifos)
        if (fifo.is_present && fifo.reader == machine.ends) {
            module = fifo.writer;
            break;
        }
    return {design().main_counter(), machine.processes[module].name};
}

/// `faster-sim check --init`: runs a configuration and writes a commented budget that this run keeps. Returns the exit
/// code; throws InputError, also if the file is there already.
int start_budget(CheckRequest const& request) {
    Budget const budget = new_budget(request);
    Machine const machine = machine_of(load_config(request.init, request.overrides).config);
    io::OutputFile const file(budget.file);
    processes::SignalWatch const watch;
    io::Scratch const place(fs::weakly_canonical(fs::absolute(budget.file)), io::Scratch::Kind::file);  // its folder
    std::vector<Budget> const one{budget};
    Outcome const outcome = run_budgets(one, {}, request, watch).front();
    if (outcome.kind != Outcome::Kind::done)
        throw InputError(budget.file.string() + ": " + why_no_result(outcome, time_limit_of(budget, request)));
    Measurement const measurement = budgets::measurement_from_text(outcome.output);
    if (measurement.kind == Measurement::Kind::deadlock) {
        warn("{}", measurement.message);
        return exit_deadlock;
    }
    if (measurement.kind != Measurement::Kind::figures)
        throw InputError(measurement.message);
    file.commit(budgets::starting_budget(budget, measurement, guarded_figures(machine), today()));
    say("written: {}\nnext: {} check {}\n", budget.file.string(), program_name(), budget.file.string());
    return exit_done;
}

namespace fs = std::filesystem;
using budgets::Budget;
using budgets::CheckResult;
using budgets::Measurement;
using processes::Outcome;
using Status = CheckResult::Status;

void require_reason(CheckRequest const& request) {
    if (!request.update && !request.reason.empty())
        throw InputError("--reason: expected --update as well");
    if (!request.update)
        return;
    if (request.reason.find_first_not_of(" \t\r\n") == std::string::npos)
        throw InputError("--update: expected --reason TEXT, which the budget keeps beside its new baseline");
    if (first_bad_byte(request.reason))
        throw InputError("--reason: expected printable UTF-8 text");
    if (!request.overrides.empty())
        throw InputError("--update: expected no --set, since the baseline is that of the budget as it is written");
}

void require_each_once(std::vector<std::string> const& files) {
    std::set<fs::path> seen;
    for (std::string const& file : files)
        if (!seen.insert(fs::weakly_canonical(fs::absolute(file))).second)
            throw InputError(file + ": stands twice on the command line, expected once");
}

std::vector<Budget> read_budgets(CheckRequest const& request) {
    require_each_once(request.budgets);
    std::vector<Budget> read;
    for (std::string const& file : request.budgets)
        read.push_back(budgets::read_budget(
            file, request.update ? budgets::BaselineNeed::optional : budgets::BaselineNeed::required));
    return read;
}

Status status_without_figures(Measurement::Kind kind) {
    switch (kind) {
        case Measurement::Kind::deadlock:
            return Status::deadlocked;
        case Measurement::Kind::bad_input:
            return Status::bad;
        default:
            return Status::crashed;
    }
}

/// The new baseline goes into the file unless it tells nothing new.
std::string update_file(Budget const& budget, budgets::Baseline const& baseline) {
    if (budget.baseline && budgets::is_same_run(*budget.baseline, baseline))
        return "baseline: nothing to update, all figures are the same";
    std::string const text = io::read_file(budget.file);
    io::write_file_atomically(budget.file, budgets::replace_baseline(text, baseline, budget.file.string()));
    return fmt::format("baseline: written, {} figures, configuration {}", baseline.figures.all().size(),
                       baseline.configuration);
}

void judge(Budget const& budget, Measurement const& measurement, CheckRequest const& request, CheckResult& result) {
    if (!request.update) {
        result.verdicts = evaluate(budget, measurement, *budget.baseline);
    } else {
        budgets::Baseline const baseline = baseline_of(measurement, budget.limits, today(), request.reason);
        result.verdicts = evaluate(budget, measurement, baseline);
        result.updated = update_file(budget, baseline);
    }
    if (budgets::has_breach(result.verdicts))
        result.status = Status::breached;
}

void compare(Budget const& budget, Measurement const& measurement, CheckRequest const& request, CheckResult& result) {
    if (budget.baseline) {
        result.baseline_date = budget.baseline->date;
        result.baseline_reason = budget.baseline->reason;
        result.explanation = explain(*budget.baseline, measurement);
    }
    if (measurement.kind == Measurement::Kind::figures)
        return judge(budget, measurement, request, result);
    result.status = status_without_figures(measurement.kind);
    // Paths in the message are relative to the budget's folder.
    bool const needs_place = result.status == Status::bad;
    result.message = needs_place ? result.file + ": " + measurement.message : measurement.message;
}

CheckResult result_of(Budget const& budget, Outcome const& outcome, CheckRequest const& request) {
    CheckResult result;
    result.name = budget.name();
    result.file = budget.file.string();
    result.seconds = outcome.seconds;
    if (outcome.kind != Outcome::Kind::done) {
        result.status = outcome.kind == Outcome::Kind::timed_out ? Status::timed_out : Status::crashed;
        result.message = why_no_result(outcome, time_limit_of(budget, request));
        return result;
    }
    try {
        compare(budget, budgets::measurement_from_text(outcome.output), request, result);
    } catch (InputError const& error) {
        result.verdicts.clear();
        result.status = Status::bad;
        result.message = error.what();
    }
    return result;
}

void print(std::vector<CheckResult> const& results) {
    for (CheckResult const& result : results)
        if (result.status == Status::bad)
            warn("{}: {}\n", program_name(), result.message);
        else
            say("{}\n", budgets::check_text(result));
    say("{}", budgets::totals_text(results));
}

int exit_code_of(std::vector<CheckResult> const& results) {
    auto const any = [&results](auto const& condition) {
        return std::any_of(results.begin(), results.end(), condition);
    };
    if (any([](CheckResult const& result) { return result.status == Status::bad; }))
        return exit_bad_input;
    return any([](CheckResult const& result) { return result.is_failure(); }) ? exit_failed_check : exit_done;
}

void require_distinct_paths(CheckRequest const& request, std::vector<Budget> const& budgets) {
    CommandPaths paths;
    for (Budget const& budget : budgets) {
        paths.reads(budget.file);
        paths.reads(budget.file.parent_path() / budget.configuration);
    }
    paths.writes("--junit", request.junit);
    paths.writes("--json", request.json);
}

int check_budgets(CheckRequest const& request) {
    require_reason(request);
    std::vector<Budget> const all = read_budgets(request);
    require_distinct_paths(request, all);
    auto const junit = io::optional_output_file(request.junit);
    auto const json = io::optional_output_file(request.json);
    processes::SignalWatch const watch;
    std::vector<Outcome> const outcomes = run_budgets(all, request.overrides, request, watch);
    std::vector<CheckResult> results;
    for (std::size_t i = 0; i < all.size(); ++i)
        results.push_back(result_of(all[i], outcomes[i], request));
    if (junit)
        junit->commit(budgets::junit_xml(results));
    if (json)
        json->commit(budgets::check_json(results));
    print(results);
    for (std::string const& file : {request.junit, request.json})
        if (!file.empty())
            say("written: {}\n", file);
    return exit_code_of(results);
}

void require_one_purpose(CheckRequest const& request) {
    if (request.init.empty() && request.budgets.empty())
        throw InputError("check: expected a budget file, or --init CONFIG to start one");
    if (request.init.empty() && !(request.out.empty() && request.trace.empty()))
        throw InputError("--out, --trace: expected --init CONFIG as well");
    if (!request.init.empty() &&
        (!request.budgets.empty() || request.update || !request.junit.empty() || !request.json.empty()))
        throw InputError("--init: expected no budgets, --update, --junit or --json beside it");
}

}  // namespace

int check(CheckRequest const& request) {
    require_one_purpose(request);
    return request.init.empty() ? check_budgets(request) : start_budget(request);
}

Subcommand check_command() {
    return {"check", "Check latency budgets: limits on the figures of runs", [](CLI::App& command) {
                auto const request = std::make_shared<CheckRequest>();
                command.add_option("budgets", request->budgets, "Budget files (docs/budgets.md)")->type_name("BUDGET");
                command.add_option("--junit", request->junit, "Write the results in the JUnit format of CI services")
                    ->type_name("FILE");
                command.add_option("--json", request->json, "Write the results, and all that moved, as JSON")
                    ->type_name("FILE");
                add_jobs(command, request->jobs, "Simulations at once");
                command
                    .add_option("--time-limit", request->time_limit_s,
                                "Give up a simulation after this time (time_limit_s, 60)")
                    ->type_name("SECONDS")
                    ->check(number_in(0.001, 86400));
                add_overrides(command, request->overrides);
                command.add_flag("--update", request->update, "Take today's figures as the baselines (needs --reason)");
                command
                    .add_option("--reason", request->reason,
                                "Why the figures may move; kept in the file with date and hash")
                    ->type_name("TEXT");
                command.add_option("--init", request->init, "Start a budget from a run of this configuration")
                    ->type_name("CONFIG");
                if (find_key("workload.trace") != nullptr)
                    command.add_option("--trace", request->trace, "With --init: replay this stimulus trace")
                        ->type_name("DIR");
                command.add_option("--out", request->out, "With --init: where to (CONFIG's name .budget.yaml)")
                    ->type_name("FILE");
                command.footer(
                    "Exit code 0: every limit is kept; 1: a limit is broken, or a run deadlocked, crashed or took too "
                    "long;\n2: a budget is no good. --set shows what a change would cost; its paths are relative to "
                    "the budget's folder.");
                return [request] { return check(*request); };
            }};
}

}  // namespace dataflow
