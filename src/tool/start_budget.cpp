#include "tool/start_budget.hpp"

#include <filesystem>
#include <fmt/format.h>

#include "kernel/base/files/output_file.hpp"
#include "kernel/base/files/scratch.hpp"
#include "kernel/base/input_error.hpp"
#include "kernel/base/program_name.hpp"
#include "kernel/budgets/starting_budget.hpp"
#include "kernel/config/design.hpp"
#include "tool/budget_run.hpp"
#include "tool/exit_codes.hpp"
#include "tool/say.hpp"

namespace faster {

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

Budget new_budget(CheckRequest const& request) {
    Budget budget;
    budget.file = request.out.empty() ? fs::path(request.init).stem().string() + ".budget.yaml" : request.out;
    if (fs::exists(budget.file))
        throw InputError(budget.file.string() + ": is there already, expected a new file (--out FILE)");
    fs::path const folder = fs::absolute(budget.file).parent_path();
    budget.configuration = seen_from(folder, request.init);
    budget.trace = seen_from(folder, request.trace);
    budget.overrides = request.overrides;
    return budget;
}

/// The module that makes the results: it writes what the one that ends samples reads.
budgets::GuardedFigures guarded_figures() {
    Machine const machine = machine_of(RunConfig());
    std::size_t module = machine.ends;
    for (MachineFifo const& fifo : machine.fifos)
        if (fifo.is_present && fifo.reader == machine.ends) {
            module = fifo.writer;
            break;
        }
    return {design().main_counter(), machine.processes[module].name};
}

}  // namespace

int start_budget(CheckRequest const& request) {
    Budget const budget = new_budget(request);
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
    file.commit(budgets::starting_budget(budget, measurement, guarded_figures(), today()));
    say("written: {}\nnext: {} check {}\n", budget.file.string(), program_name(), budget.file.string());
    return exit_done;
}

}  // namespace faster
