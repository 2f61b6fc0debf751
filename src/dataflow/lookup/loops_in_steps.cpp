#include "dataflow/lookup/loops_in_steps.hpp"

#include <algorithm>
#include <numeric>

namespace dataflow::timing {

namespace {
using Kind = Operation::Kind;
constexpr std::uint64_t longest_lag = 4096;
constexpr std::uint64_t most_in_two = std::uint64_t{1} << 22;  // iterations of a sample

std::uint64_t iterations_of(std::vector<Operation> const& operations) {
    return std::accumulate(operations.begin(), operations.end(), std::uint64_t{0},
                           [](std::uint64_t sum, Operation const& operation) { return sum + operation.iterations(); });
}

/// Equal iterations at the front of a log, without silent ones in between.
struct Run {
    Ports::Number ports = 0;
    std::uint32_t count = 0;
};

Run take_run(OperationLog& log, std::uint64_t most) {
    Operation const operation = log.front();
    bool const has_tail = operation.tail_ports() != 0;
    auto const count = static_cast<std::uint32_t>(std::min<std::uint64_t>(most, operation.count()));
    if (operation.gap() == 0) {
        bool const is_whole = count == operation.count() && !has_tail;
        log.consume(is_whole ? 1 : 0, is_whole ? 0 : count);
        return {operation.ports(), count};
    }
    bool const is_last = operation.count() == 1 && !has_tail;
    log.consume(is_last ? 1 : 0, is_last ? 0 : 1);
    log.put_back(Operation(Kind::iterate, 0, 0, operation.gap()));
    return {operation.ports(), 1};
}

bool iterates(Operation const& operation) {
    return operation.kind() == Kind::iterate || operation.kind() == Kind::mixed || operation.kind() == Kind::flanked;
}

/// A FIFO has both its ends at the process: how many tokens many steps at once find there changes while they are done.
bool reads_what_it_writes(ProcessTiming const& process) {
    for (unsigned one = 0; one < process.port_count(); ++one)
        for (unsigned other = 0; other < one; ++other)
            if (&process.fifo(one) == &process.fifo(other))
                return true;
    return false;
}
}  // namespace

std::unique_ptr<LoopsInSteps> LoopsInSteps::of(ProcessTiming& process, bool in_two) {
    std::vector<LoopShape> const& loops = process.loops();
    bool const makes_attempts =
        std::any_of(loops.begin(), loops.end(), [](LoopShape const& loop) { return loop.makes_attempts; });
    if (makes_attempts || process.flushes() || process.stream() != nullptr || reads_what_it_writes(process))
        return nullptr;
    auto shape = std::make_shared<ProcessShape>(*process.shape());
    std::vector<std::optional<Steps>> steps;
    bool has_any = false;
    for (std::size_t i = 0; i < loops.size(); ++i) {
        steps.push_back(steps_of(process, loops[i], shape->plans[i]));
        if (steps.back() && steps.back()->offset > 0 && !in_two)
            steps.back().reset();
        if (!steps.back())
            continue;
        shape->plans[i] = shape->plans[i].in_steps();
        has_any = true;
    }
    if (!has_any)
        return nullptr;
    ProcessTiming::View(process).set_shape(std::move(shape));
    return std::unique_ptr<LoopsInSteps>(new LoopsInSteps(process, std::move(steps)));
}

/// Where somebody reads what is written at once and what is written late, the automaton cannot take back what he has
/// waited for the one when he waits for the other for ever.
std::optional<LoopsInSteps::Steps> LoopsInSteps::steps_of(ProcessTiming& process, LoopShape const& loop,
                                                          LoopPlan const& plan) {
    if (plan.aligned || loop.rewinds || plan.phases.size() > 2 || plan.phases.front().offset != 0 ||
        plan.longest_lag > longest_lag || plan.phases.back().offset > longest_lag || loop.reads.empty() ||
        loop.writes.empty())
        return std::nullopt;
    auto const readers_of = [&process](Ports::Number ports) {
        ProcessMask readers = 0;
        Ports(ports).each([&](unsigned port) {
            readers |= process.writes(port) ? ProcessTiming::View(process).port(port).neighbour : 0;
        });
        return readers;
    };
    Steps steps;
    steps.lag = static_cast<std::uint32_t>(plan.longest_lag);
    steps.offset = static_cast<std::uint32_t>(plan.phases.back().offset);
    for (LoopPhase const& phase : plan.phases)
        for (auto const& [port, lag] : phase.ports) {
            bool const is_early = lag == 0 && phase.offset == 0;
            bool const is_late = lag == plan.longest_lag && phase.offset == steps.offset;
            if (port >= Ports::in_masks || (!is_early && !is_late))
                return std::nullopt;
            (is_early ? steps.early : steps.late) |= Ports::of(port).number();
        }
    if ((readers_of(steps.early) & readers_of(steps.late)) != 0)
        return std::nullopt;
    return steps;
}

void LoopsInSteps::rewrite() {
    OperationLog& log = process_.log();
    if (!log.take_told(told_))
        return;
    for (Operation const& operation : told_)
        take(operation);
    pass_due();
    end_run();
    log.note_taken();
    late_.compact();
}

void LoopsInSteps::pass_over() { process_.log().note_taken(); }

bool LoopsInSteps::rewrite(std::vector<Operation>& operations) {
    if (is_told_in_two() && iterations_of(operations) > most_in_two)
        return false;
    OperationLog& log = process_.log();
    log.clear();
    for (Operation const& operation : operations)
        log.append(operation);
    rewrite();
    operations.assign(log.begin(), log.begin() + log.pending());
    log.clear();
    return steps_ == nullptr;
}

/// Two operations for each iteration.
bool LoopsInSteps::is_told_in_two() const {
    return std::any_of(loops_.begin(), loops_.end(),
                       [](std::optional<Steps> const& steps) { return steps && steps->offset > 0; });
}

void LoopsInSteps::add_form(std::vector<std::uint64_t>& form) const {
    form.push_back(process_.index());
    for (std::size_t loop = 0; loop < loops_.size(); ++loop) {
        Steps const steps = loops_[loop].value_or(Steps{});
        form.insert(form.end(),
                    {steps.lag, steps.offset, steps.early, steps.late, process_.loops()[loop].interval.achieved});
    }
}

void LoopsInSteps::take(Operation const& operation) {
    if (steps_ == nullptr) {
        put(operation);
        if (operation.kind() == Kind::enter)
            enter(operation.count());
    } else if (iterates(operation)) {
        iterate(operation);
    } else if (operation.kind() == Kind::leave) {
        leave();
        put(operation);
    } else {  // happens between two steps
        pass_due();
        put(operation);
    }
}

void LoopsInSteps::enter(std::size_t loop) {
    if (!loops_[loop])
        return;
    steps_ = &*loops_[loop];
    interval_ = static_cast<std::uint32_t>(process_.loops()[loop].interval.achieved);
    late_.clear();
    if (steps_->lag > 0)
        late_.append(Operation(Kind::iterate, 0, 0, steps_->lag));
}

void LoopsInSteps::iterate(Operation const& operation) {
    if ((operation.all_ports() & ~steps_->late) != 0) {
        iterate_in_both(operation);
        return;
    }
    late_.append(operation);
    due_ += operation.iterations();
    pass_whole();
}

void LoopsInSteps::iterate_in_both(Operation const& operation) {
    pass_due();
    at_hand_.append(operation);
    while (!at_hand_.exhausted()) {
        Run const run = take_run(at_hand_, Operation::longest_count);
        late_.append(Operation(Kind::iterate, run.ports & steps_->late, 0, run.count));
        for (std::uint32_t left = run.count; left > 0;) {
            Run const late = take_run(late_, left);
            put(run.ports & steps_->early, late.ports, late.count);
            left -= late.count;
        }
    }
}

/// What is left belongs to iterations that have begun.
void LoopsInSteps::leave() {
    pass_due();
    while (!late_.exhausted()) {
        Run const run = take_run(late_, Operation::longest_count);
        for (std::uint32_t i = 0; i < run.count; ++i)
            put_drained(run.ports);
    }
    steps_ = nullptr;
}

void LoopsInSteps::put_drained(Ports::Number late) {
    if (late == 0) {
        put(Operation(Kind::wait, 0, 0, interval_));
        return;
    }
    if (steps_->offset > 0)
        put(Operation(Kind::wait, 0, 0, steps_->offset));
    put(Operation(Kind::step, late, 0, interval_ - steps_->offset));
}

/// Operations of which all steps are due.
void LoopsInSteps::pass_whole() {
    if (steps_->offset > 0)
        return;
    while (!late_.exhausted() && late_.begin()->iterations() <= due_) {
        Operation const operation = *late_.begin();
        due_ -= operation.iterations();
        late_.consume();
        put(operation);
    }
}

void LoopsInSteps::pass_due() {
    if (steps_ == nullptr)
        return;
    pass_whole();
    while (due_ > 0) {
        Run const run = take_run(late_, due_);
        due_ -= run.count;
        put(0, run.ports, run.count);
    }
}

void LoopsInSteps::put(Ports::Number early, Ports::Number late, std::uint32_t iterations) {
    if (steps_->offset > 0)
        put_in_two(early, late, iterations);
    else
        put(static_cast<Ports::Number>(early | late), iterations);
}

void LoopsInSteps::put_in_two(Ports::Number early, Ports::Number late, std::uint32_t iterations) {
    bool const is_silent = early == 0 && late == 0;
    std::uint32_t const at_once = is_silent ? Operation::longest_count / steps_->offset : 1;
    for (std::uint32_t left = iterations; left > 0;) {
        std::uint32_t const count = std::min(left, at_once);
        put(early == 0 ? Operation(Kind::wait, 0, 0, count * steps_->offset)
                       : Operation(Kind::step, early, 0, steps_->offset));
        put(Operation(Kind::iterate, late, 0, count));
        left -= count;
    }
}

void LoopsInSteps::put(Ports::Number ports, std::uint32_t steps) {
    if (run_ > 0 && (ports != run_ports_ || run_ + steps > Operation::longest_count))
        end_run();
    run_ports_ = ports;
    run_ += steps;
}

void LoopsInSteps::put(Operation const& operation) {
    end_run();
    process_.log().append(operation);
}

void LoopsInSteps::end_run() {
    if (run_ > 0)
        process_.log().append(Operation(Kind::iterate, run_ports_, 0, run_));
    run_ = 0;
}

}  // namespace dataflow::timing
