#include "dataflow/tools/sizing/size_fifos.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <stdexcept>

#include "dataflow/base/counted_progress.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/run/config/design.hpp"

namespace dataflow::sizing {

namespace {

constexpr std::size_t steps_to_the_answer = 3;  // unbounded, cheapest, shallowest

SizedChoice sized(Choice const& choice, Cycles total_cycles, FifoFrame const& frame) {
    Primitives const primitives = sum_of(choice, frame.freedoms, frame.weights);
    return {choice, total_cycles, primitives, cost_of(primitives, frame.weights)};
}

/// The deepest that the primitives of an answer hold.
Choice holding(Choice choice, Machine const& machine, FifoFrame const& frame) {
    for (std::size_t const i : fifos_of(machine))
        choice[i] = deepest_alike(choice[i], frame.freedoms[i], frame.weights);
    return choice;
}

/// Takes every step down that is within the bound, until none is. Where times are monotone there is none.
Found certified(Found found, RepairedSearch& search, CoreTimes& times, Sizing& sizing, CountedProgress& steps) {
    FifoFrame const frame(sizing.machine, sizing.options.weights);
    auto const is_within = [&sizing](CertificateRow const& row) { return !row.breaks(sizing.bound); };
    for (;;) {
        std::vector<CertificateRow>& rows = sizing.certificate;
        rows = steps_down(frame, found.choice);
        steps.expect(rows.size());
        time_steps(found.choice, sizing.bound, times, sizing.options.jobs, rows, [&] { steps.one_more(); });
        auto const row = std::find_if(rows.begin(), rows.end(), is_within);
        if (row == rows.end())
            return found;
        if (times.is_monotone())
            throw std::logic_error("a shallower FIFO is within the bound: " + sizing.machine.fifos[row->fifo].name);
        found.choice[row->fifo] = row->shallower;
        found = search.timed(search.replaced(found, found.choice));
    }
}

/// What is configured, if it is within the bound and costs less than what was found: where times are not monotone,
/// no search looks everywhere.
Found or_configured(Found const& found, RepairedSearch& search, CoreTimes& times, Sizing const& sizing) {
    FifoFrame const frame(sizing.machine, sizing.options.weights);
    Choice const configured = choice_of(sizing.machine);
    bool const is_better = !times.is_monotone() &&
                           sized(configured, 0, frame).cost < sized(found.choice, 0, frame).cost &&
                           times.total_cycles(configured, sizing.options.jobs) <= sizing.bound;
    return is_better ? search.timed(search.replaced(found, configured)) : found;
}

}  // namespace

void require_sense(SizingOptions const& options) {
    auto const require = [](char const* name, double value, double least, double most) {
        if (!(value >= least && value <= most))  // not a number is in no range
            throw InputError(
                fmt::format("size_fifos: {} = {}, expected a number from {} to {}", name, value, least, most));
    };
    require("within_percent", options.within_percent, 0, most_within_percent);
    require("luts_per_ramb36", options.weights.luts_per_ramb36, least_luts_of_ramb36, most_luts_of_ramb36);
    require("front_points", options.front_points, 0, most_front_points);
}

void require_sizable(Machine const& machine) {
    for (MachineFifo const& fifo : machine.fifos)
        if (fifo.hands_over > 0)
            throw InputError("size-fifos: " + fifo.name +
                             " hands over calls, which are not sized, expected a design without ping-pong buffers and "
                             "with accelerator.calls overlapped");
}

Cycles bound_within(double percent, Cycles unbounded_cycles) {
    constexpr double rounding = 1e-6;  // a whole number of cycles is one, however the percentage is rounded
    return unbounded_cycles +
           static_cast<Cycles>(std::floor(static_cast<double>(unbounded_cycles) * percent / 100 + rounding));
}

Sizing size_fifos(replay::RecordedRun const& run, RunConfig const& config, SizingOptions const& options,
                  TellProgress const& progress) {
    require_sense(options);
    Machine const machine = machine_of(config);
    require_sizable(machine);
    FifoFrame const frame(machine, options.weights);
    CoreTimes times(run, machine, options.before_retiming);
    CountedProgress steps(steps_to_the_answer + (options.front_points > 0 ? options.front_points + 1 : 0), progress);
    Sizing sizing;
    sizing.options = options;
    sizing.config = config;
    sizing.machine = machine;
    Unbounded const deep = unbounded(frame, times, options.jobs);
    sizing.unbounded = sized(deep.choice, deep.total_cycles, frame);
    sizing.bound = bound_within(options.within_percent, deep.total_cycles);
    steps.one_more();

    RepairedSearch search(frame, times, deep, {options.jobs, options.most_retimings});
    Found found = search.cheapest(sizing.bound);
    steps.one_more();
    found = search.shallowest(found, sizing.bound);
    steps.one_more();
    found = certified(or_configured(found, search, times, sizing), search, times, sizing, steps);
    sizing.answer = sized(found.choice, found.total_cycles, frame);
    sizing.is_proven = found.is_proven;
    sizing.is_given_up = found.is_given_up;
    sizing.least_cost = found.least_cost;
    sizing.holds = holding(found.choice, machine, frame);
    if (!times.is_monotone())
        sizing.holds_cycles = times.total_cycles(sizing.holds, options.jobs);

    Choice const configured = choice_of(machine);
    sizing.configured = sized(configured, times.total_cycles(configured, options.jobs), frame);
    if (options.front_points > 0)
        sizing.front =
            front(frame, search, deep.total_cycles, sizing.bound, options.front_points, [&] { steps.one_more(); });
    sizing.retimed_cores = times.retimed_cores();
    return sizing;
}

}  // namespace dataflow::sizing
