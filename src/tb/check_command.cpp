#include "tb/check_command.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <memory>
#include <set>
#include <thread>

#include "budgets/baseline_text.hpp"
#include "budgets/budget_file.hpp"
#include "budgets/check_json.hpp"
#include "budgets/check_text.hpp"
#include "budgets/junit_xml.hpp"
#include "budgets/replace_baseline.hpp"
#include "budgets/starting_budget.hpp"
#include "common/input_error.hpp"
#include "config/plain_text.hpp"
#include "io/atomic_file.hpp"
#include "io/output_file.hpp"
#include "io/text_file.hpp"
#include "processes/process_pool.hpp"
#include "tb/budget_run.hpp"
#include "tb/run_command.hpp"

namespace faster {

namespace {

namespace fs = std::filesystem;
using budgets::Budget;
using budgets::CheckResult;
using budgets::Measurement;
using processes::Outcome;
using Status = CheckResult::Status;

std::string today() { return fmt::format("{:%Y-%m-%d}", fmt::gmtime(std::time(nullptr))); }

std::size_t jobs_of(CheckRequest const& request) {
    return request.jobs > 0 ? static_cast<std::size_t>(request.jobs)
                            : std::max<std::size_t>(1, std::thread::hardware_concurrency());
}

double time_limit_of(CheckRequest const& request, Budget const& budget) {
    return request.time_limit_s > 0 ? request.time_limit_s : budget.time_limit_s;
}

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

std::vector<Outcome> run_all(std::vector<Budget> const& all, CheckRequest const& request,
                             processes::SignalWatch const& watch) {
    std::vector<processes::Task> tasks;
    tasks.reserve(all.size());
    for (Budget const& budget : all)
        tasks.push_back({[&budget, &request] { return to_text(measure(budget, request.overrides)); },
                         time_limit_of(request, budget)});
    return processes::run_all(tasks, jobs_of(request), watch);
}

/// Without figures: why the simulation has none.
void note_failure(Outcome const& outcome, double time_limit_s, CheckResult& result) {
    result.status = outcome.kind == Outcome::Kind::timed_out ? Status::timed_out : Status::crashed;
    if (outcome.kind == Outcome::Kind::timed_out)
        result.message =
            fmt::format("no result after {:g} s, the simulation was ended (time_limit_s, --time-limit)", time_limit_s);
    else if (outcome.kind == Outcome::Kind::crashed)
        result.message = fmt::format("the simulation was ended by signal {} ({})", outcome.signal,
                                     strsignal(outcome.signal));  // NOLINT(concurrency-mt-unsafe): one thread
    else
        result.message = fmt::format("the simulation ended with exit code {} and no result", outcome.exit_code);
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
        note_failure(outcome, time_limit_of(request, budget), result);
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
            fmt::print(stderr, "faster-sim: {}\n", result.message);
        else
            fmt::print("{}\n", budgets::check_text(result));
    fmt::print("{}", budgets::totals_text(results));
}

int exit_code_of(std::vector<CheckResult> const& results) {
    auto const any = [&results](auto const& condition) {
        return std::any_of(results.begin(), results.end(), condition);
    };
    if (any([](CheckResult const& result) { return result.status == Status::bad; }))
        return exit_bad_input;
    return any([](CheckResult const& result) { return result.is_failure(); }) ? exit_failed_check : exit_done;
}

/// Checked before the work whose output would be lost.
std::unique_ptr<io::OutputFile> output_file(std::string const& path) {
    return path.empty() ? nullptr : std::make_unique<io::OutputFile>(path);
}

int check_budgets(CheckRequest const& request) {
    require_reason(request);
    std::vector<Budget> const all = read_budgets(request);
    auto const junit = output_file(request.junit);
    auto const json = output_file(request.json);
    processes::SignalWatch const watch;
    std::vector<Outcome> const outcomes = run_all(all, request, watch);
    std::vector<CheckResult> results;
    for (std::size_t i = 0; i < all.size(); ++i)
        results.push_back(result_of(all[i], outcomes[i], request));
    if (junit)
        junit->commit(budgets::junit_xml(results));
    if (json)
        json->commit(budgets::check_json(results));
    print(results);
    return exit_code_of(results);
}

/// How a file in `folder` names a path that the caller gives relative to the current folder.
std::string seen_from(fs::path const& folder, std::string const& path) {
    if (path.empty() || fs::path(path).is_absolute())
        return path;
    return fs::weakly_canonical(fs::absolute(path)).lexically_relative(fs::weakly_canonical(folder)).string();
}

Budget new_budget(CheckRequest const& request) {
    Budget budget;
    budget.file = request.out.empty() ? fs::path(request.init).stem().string() + ".budget.yaml" : request.out;
    if (fs::exists(budget.file))
        throw InputError(budget.file.string() + ": is there already, expected a new file (--out FILE)");
    fs::path const folder = fs::absolute(budget.file).parent_path();
    if (!fs::is_directory(folder))
        throw InputError(fmt::format("{}: its folder does not exist", budget.file.string()));
    budget.configuration = seen_from(folder, request.init);
    budget.trace = seen_from(folder, request.trace);
    budget.overrides = request.overrides;
    return budget;
}

int start_budget(CheckRequest const& request) {
    Budget const budget = new_budget(request);
    io::OutputFile const file(budget.file);
    processes::SignalWatch const watch;
    CheckRequest of_budget = request;
    of_budget.overrides.clear();  // they are the budget's own now
    std::vector<Outcome> const outcomes = run_all({budget}, of_budget, watch);
    CheckResult result;
    if (outcomes.front().kind != Outcome::Kind::done) {
        note_failure(outcomes.front(), time_limit_of(request, budget), result);
        throw InputError(budget.file.string() + ": " + result.message);
    }
    Measurement const measurement = budgets::measurement_from_text(outcomes.front().output);
    if (measurement.kind == Measurement::Kind::deadlock) {
        fmt::print(stderr, "{}", measurement.message);
        return exit_deadlock;
    }
    if (measurement.kind != Measurement::Kind::figures)
        throw InputError(measurement.message);
    file.commit(budgets::starting_budget(budget, measurement, today()));
    fmt::print("written: {}\nnext: faster-sim check {}\n", budget.file.string(), budget.file.string());
    return exit_done;
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

}  // namespace faster
