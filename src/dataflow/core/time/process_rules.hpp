#pragma once
#include <algorithm>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "dataflow/core/time/fifo_rules.hpp"
#include "dataflow/core/time/flushing_pipeline.hpp"
#include "dataflow/core/time/operation_log.hpp"
#include "dataflow/core/time/ports.hpp"
#include "dataflow/core/time/process_shape.hpp"
#include "dataflow/core/time/process_state.hpp"
#include "dataflow/core/time/trail.hpp"

namespace dataflow::timing {

/// The rules of time of a process (docs/timing-model.md): the step, the pipelined loop with its delay line, the setup,
/// the steps of a flushing pipeline; those of attempts are in attempts.cpp. The local time moves by what an operation
/// takes and by waiting; leaving a loop that is shallower than its interval sets it back.
///
/// Iterations are done one by one here. Nobody waits for that long: BulkRuns does many at a time.
///
/// `Process`, which derives from this, knows the FIFOs at its ports and counts what happens. `Port` has a number and an
/// end of a FIFO, and so decides how cycles are held (see FifoRules), and with them the local time. `Process` has
///
///     std::vector<Port> ports_                      in program order of a step
///     void put_in_order(PortSet&) const             the order in which a step waits for its ports
///     bool may_access(Ports::Number ports)           false: stops in front of the step, whatever it is
///     void wait_for(Port const&)                    stops, as the earliest cycle of an access there is not known
///     void charge(Port const&, Time stall)          has waited so long, up to the local time, for an access
///     void performs(Ports::Number ports, Time arrival)  a step takes place at the local time
///     void note(Port const&, std::uint64_t count)   so many accesses have been entered in the FIFO
///     void count(std::uint64_t iterations)          of the loop it is in
///     void iterates(std::uint64_t first, std::uint64_t count)  they begin at the local time
///     void entered(), entered_again(), count_end(), left()  a loop
///     void awaited_setup(Time cycles), awaited_write(Cycles cycles), stamped()
///     Time first_call() const                       the cycle in which the first call may begin
///     void let_bubbles_in(Port const&, Time bubbles, Time from)  a flushing pipeline, instead of what a port reads
///     void lets_out(Port const&, Time due, Time cycle)  a token, which may have waited; told before the access
///     void waits_for_room(Port const&)  for a token in a flushing pipeline, whatever else it waits for
///     bool choose(Operation const&)  what a process that makes attempts says; false: it waits
template <class Process, class Port> class ProcessRules {
  public:
    using Line = typename Port::Line;
    using Time = typename Line::Time;

    ProcessState<Time> const& state() const { return state_; }
    OperationLog const& log() const { return log_; }
    /// Nothing is left to be done, nor in its flushing pipeline.
    bool finished() const { return log_.exhausted() && !state_.flushing.is_waiting(); }
    bool flushes() const { return shape_->flushing_stages > 0; }
    bool in_loop() const { return state_.in_loop; }
    /// In an iteration that has begun, with its first step, and whose steps are not all over.
    bool is_in_iteration() const {
        PipelinePosition const& pipeline = state_.pipeline;
        return state_.in_loop && pipeline.open && pipeline.counts && pipeline.phase > 0;
    }
    bool rests() const { return state_.rests; }
    bool drains() const {
        return state_.rests || (!log_.exhausted() && log_.begin()->kind() == Operation::Kind::leave);
    }
    LoopPlan const& plan() const { return *plan_; }
    /// The accesses of the step that a process has stopped in front of which goes step by step.
    Ports step_at_hand() const {
        bool const is_in_pipeline =
            state_.in_loop && !plan_->aligned && state_.pipeline.open && state_.pipeline.phase < plan_->phases.size();
        return is_in_pipeline ? ports_in(plan_->phases[state_.pipeline.phase]) : Ports(log_.front().ports());
    }
    /// No access to come is before this cycle: the local time, less what the process goes back when it leaves a loop
    /// whose last tokens are out before the last initiation interval is over.
    Time not_before() const {
        return state_.in_loop ? state_.time + static_cast<Time>(std::min<std::int64_t>(plan_->drain, 0)) : state_.time;
    }

    /// What it has yet to read and to write must be told. Not of a loop that takes from memory: see BulkRuns.
    bool has_delay_line() const { return state_.in_loop && !plan_->aligned && !is_in_stream_loop(); }
    bool is_in_stream_loop() const { return state_.in_loop && shape_->loops[state_.loop].uses_stream; }

    /// Takes up where another state has left a process: its loop, from 1 on, or 0, and how many iterations have begun.
    /// What it has yet to write is a delay line, from the latest iteration on. Of a loop that takes from memory only
    /// the time.
    void restore(Time time, unsigned loop, std::uint64_t iterations) {
        state_.time = time;
        ++run_;
        if (is_in_stream_loop())
            return;
        state_.iterations = iterations;
        be_in_loop(loop);
        if (!state_.in_loop)
            return;
        begin_pipeline();
        state_.pipeline.iteration = plan_->longest_lag;
    }
    void restore_delayed(std::uint64_t lag, Ports::Number ports) { state_.delayed(lag) = ports; }
    bool sets_up_ahead() const { return shape_->sets_up_ahead; }
    bool has_interlocks() const { return shape_->has_interlocks; }
    /// What its loop has waited for writes, as far as that decides anything.
    std::vector<typename ProcessState<Time>::WriteWait> const& latest_write_waits() {
        if (state_.in_loop && !state_.write_waits.empty())
            forget_write_waits();
        return state_.write_waits;
    }
    std::vector<typename ProcessState<Time>::WriteWait>& restored_write_waits() {
        state_.write_waits.clear();
        return state_.write_waits;
    }
    std::vector<Time>& restored_setups() {
        state_.setups_done.clear();
        return state_.setups_done;
    }
    FlushingPipeline<Time>& restored_flushing() {
        state_.flushing.clear();
        return state_.flushing;
    }
    void put_back(Operation const& operation) { log_.put_back(operation); }

  protected:
    using Kind = Operation::Kind;

    /// Ports that are accessed together, in program order. Copies: one place less to look at.
    using PortSet = std::vector<Port>;

    explicit ProcessRules(std::shared_ptr<ProcessShape> shape, unsigned index)
        : shape_(std::move(shape)), index_(index) {}

    void go_on() {
        while (!log_.exhausted() && take()) {
        }
        if (flushes())
            flush();
    }

    /// Does what it can of the front operation. True: that is done, or part of it, and the log is to be looked at
    /// again.
    bool take() {
        Operation const operation = log_.whole_front();
        if (state_.rests && !shape_->goes_on_with(operation, state_.loop))
            return leave();
        switch (operation.kind()) {
            case Kind::wait:
                if (operation.is_choice()) {
                    if (!self().choose(operation))
                        return false;
                } else if (!operation.is_plain_wait())
                    await(operation);
                else if (!flushes())
                    pass(operation.count());
                else if (!pass_flushing(operation))
                    return false;
                break;
            case Kind::step:
                if (flushes())
                    return perform_flushing(operation);
                if (!perform(operation.ports()))
                    return false;
                pass(operation.count());
                break;
            case Kind::enter:
                if (state_.rests)
                    enter_again();
                else
                    enter(operation.count());
                break;
            case Kind::leave:
                state_.rests = shape_->loops[state_.loop].rewinds;
                if (!state_.rests && !leave())
                    return false;
                break;
            case Kind::stamp:
                ++state_.stamps_held;
                if (!state_.rests)
                    release_stamps();
                break;
            case Kind::iterate:
            case Kind::mixed:
            case Kind::flanked:
                return self().do_iterations(operation);
        }
        log_.consume();
        return true;
    }

    /// From 1 on; 0: in none.
    void be_in_loop(unsigned number) {
        state_.in_loop = number != 0;
        if (!state_.in_loop)
            return;
        state_.loop = number - 1;
        plan_ = &shape_->plans[state_.loop];
    }
    void begin_pipeline() {
        state_.pipeline = PipelinePosition{};
        state_.pipeline.drain_left = plan_->longest_lag;
        if (!plan_->aligned)
            state_.delay_line.assign(plan_->delay_line_length, 0);
    }
    Region region_at_hand() const {
        if (!state_.in_loop)
            return Region();
        return Region::of_loop(state_.loop, drains() ? Region::Part::drain : Region::Part::iterations);
    }
    void leave_trail(unsigned port) {
        note_wait(self().ports_[port], region_at_hand(), state_.in_loop ? state_.pipeline.offset : 0, 0, state_.time);
    }
    /// The trail learns that the process waited for a port, up to a cycle, in a step of a region so many steps after
    /// its iteration's first.
    void note_wait(Port const& port, Region region, Cycles step, Time /*from*/, Time until) {
        trail_->stalled(index_, port.number, region, step, static_cast<Cycles>(until));
    }

    /// To a step of the flushing pipeline; those before it took in bubbles instead of what a port reads.
    void go_to(typename FlushingPipeline<Time>::Step const& step, Port const& port) {
        Time const from = state_.time;
        state_.flushing.go_to(step);
        state_.time = step.cycle;
        if (step.steps > 0)
            self().let_bubbles_in(port, step.steps, from);
    }

    Port const& flushing_port() const { return self().ports_[shape_->flushing_port]; }
    /// Of tokens in the pipeline, those for which there is known to be room.
    void let_out() {
        if (!state_.flushing.is_waiting())
            return;
        Port const& out = flushing_port();
        state_.flushing.let_out(
            state_.time, [&out] { return out.end.known() > 0; }, [&out] { return out.end.earliest(); },
            [this, &out](auto const& token, Time due, Time cycle) {
                self().lets_out(out, due, cycle);
                if (trail_ != nullptr)
                    trail_->flown(index_, out.number, static_cast<Cycles>(token.flight), token.was_frozen,
                                  static_cast<Cycles>(cycle));
                out.end.access(cycle);
                self().note(out, 1);
            });
    }
    /// All of an iteration that is split off an operation, which may become its tail; or the next is the front one.
    void take_off(Operation& operation, std::uint32_t count) {
        operation.subtract(count);
        if (operation.count() > 0)
            return;
        ++run_;
        if (operation.own_tail_ports() != 0)
            operation.become_tail();
        else
            log_.consume();
    }

    [[gnu::always_inline]] PortSet const& port_set(Ports::Number ports) const {
        if (__builtin_expect(ports >= sets_.size() || sets_[ports] == nullptr ? 1 : 0, 0) != 0)
            make_port_set(ports);
        return *sets_[ports];
    }
    /// Ports stand in program order by their numbers, or as Process says.
    void put_in_order(PortSet& /*set*/) const {}
    /// The ports have changed.
    void forget_port_sets() { sets_.clear(); }

    std::shared_ptr<ProcessShape> shape_;
    unsigned index_;
    ProcessState<Time> state_;
    LoopPlan const* plan_ = nullptr;  ///< of the loop it is in
    OperationLog log_;
    Trail* trail_ = nullptr;
    std::uint64_t run_ = 0;  ///< a number that no two operations of iterations have

    Process& self() { return static_cast<Process&>(*this); }
    Process const& self() const { return static_cast<Process const&>(*this); }

    void pass(std::uint64_t cycles) { state_.time += static_cast<Time>(cycles); }
    void mark(Region region) {
        if (trail_ != nullptr)
            trail_->marked(index_, region, static_cast<Cycles>(state_.time));
    }
    void mark_loop(Region::Part part) { mark(Region::of_loop(state_.loop, part)); }
    void count(std::uint64_t iterations) {
        state_.iterations += iterations;
        self().count(iterations);
    }

    // The step.

    /// All accesses of a step together, if their earliest cycles are known: waits for each in program order, charging
    /// what each adds.
    bool perform(Ports::Number ports) {
        PortSet const& set = port_set(ports);
        for (Port const& port : set)
            if (port.end.known() == 0) {
                self().wait_for(port);
                return false;
            }
        if (!self().may_access(ports))
            return false;
        Time const arrival = state_.time;
        Port const* waited_for = nullptr;
        for (Port const& port : set) {
            Time const earliest = port.end.earliest();
            if (earliest <= state_.time)
                continue;
            Time const stall = earliest - state_.time;
            state_.time = earliest;
            waited_for = &port;
            self().charge(port, stall);
        }
        if (trail_ != nullptr && waited_for != nullptr)
            self().note_wait(*waited_for, region_at_hand(), state_.in_loop ? state_.pipeline.offset : 0, arrival,
                             state_.time);
        self().performs(ports, arrival);
        for (Port const& port : set) {
            port.end.access(state_.time);
            self().note(port, 1);
        }
        return true;
    }

    // The flushing pipeline.

    /// Reads happen in a step of the pipeline; what is written to the FIFO behind it begins its way there.
    bool perform_flushing(Operation const& operation) {
        PortSet const& set = port_set(operation.ports());
        let_out();
        Port const* last = nullptr;  // that can be read
        for (Port const& port : set) {
            if (port.number == shape_->flushing_port)
                continue;
            if (port.end.known() == 0) {
                self().wait_for(port);
                return false;
            }
            if (last == nullptr || port.end.earliest() > last->end.earliest())
                last = &port;
        }
        if (last != nullptr && !read_flushing(operation.ports(), *last))
            return false;
        for (Port const& port : set) {
            if (port.number == shape_->flushing_port) {
                state_.flushing.take_in(static_cast<Time>(shape_->flushing_stages));
                continue;
            }
            port.end.access(state_.time);
            self().note(port, 1);
        }
        log_.whole_front() = Operation(Kind::wait, 0, 0, operation.count());
        return true;
    }

    /// Goes to the step in which it can.
    bool read_flushing(Ports::Number ports, Port const& last) {
        auto const step = state_.flushing.step_from(state_.time, last.end.earliest());
        if (step.is_open) {
            self().wait_for(flushing_port());
            return false;
        }
        if (!self().may_access(ports))
            return false;
        Time const arrival = state_.time;
        go_to(step, last);
        if (trail_ != nullptr && state_.time > arrival)
            leave_trail(step.ends_freeze ? shape_->flushing_port : last.number);
        self().performs(ports, arrival);
        return true;
    }

    /// So many steps of the pipeline, as far as it is known when tokens leave in them.
    bool pass_flushing(Operation const& wait) {
        let_out();
        auto const step = state_.flushing.step_after(state_.time, static_cast<Time>(wait.count()));
        state_.flushing.go_to(step);
        state_.time = step.cycle;
        log_.whole_front().subtract(static_cast<std::uint32_t>(step.steps));
        if (step.is_open)
            self().wait_for(flushing_port());
        return !step.is_open;
    }

    void flush() {
        let_out();
        if (state_.flushing.is_waiting())
            self().waits_for_room(flushing_port());
    }

    // Setups, and iterations that wait for a write.

    void await(Operation const& operation) {
        Cycles const cycles = shape_->setup_cycles;
        if (operation.awaits_write()) {
            await_write(operation.dependence(), operation.count());
        } else if (operation.gap() == Operation::setup_begin) {
            state_.setups_done.push_back(state_.time + static_cast<Time>(cycles));
        } else if (operation.gap() == Operation::setup_end) {
            await_setup();
        } else if (operation.gap() == Operation::call_start) {
            bool const is_in_turn = shape_->call_start.is_in_turn;
            if (wait_in_setup(is_in_turn ? state_.time + call_delay() : self().first_call()))
                mark(Region());
        } else {
            mark(Region::setup());
            pass(cycles * operation.count());
            mark(Region());
        }
    }
    /// What a call waits for, from the begin of the region that it is part of.
    Time call_delay() const { return static_cast<Time>(shape_->call_start.after); }
    void await_setup() {
        Time const done = state_.setups_done.front();
        state_.setups_done.erase(state_.setups_done.begin());
        if (wait_in_setup(done))
            mark_loop(Region::Part::iterations);
    }
    bool wait_in_setup(Time until) {
        if (until <= state_.time)
            return false;
        mark(Region::setup());
        self().awaited_setup(until - state_.time);
        state_.time = until;
        return true;
    }

    /// A frozen pipeline keeps its iterations as many steps apart as they were begun: II, and the waits in between.
    /// Nothing else decides how long one waits.
    void await_write(std::uint32_t dependence, std::uint64_t distance) {
        std::vector<Cycles> const& spans = shape_->loops[state_.loop].interlock_spans;
        if (dependence >= spans.size())
            return;
        Cycles steps = distance * plan_->ii;
        for (auto const& before : state_.write_waits)
            if (is_within(before.iteration, distance))
                steps += before.steps;
        if (steps >= spans[dependence])
            return;
        Cycles const wait = spans[dependence] - steps;
        forget_write_waits();
        state_.write_waits.push_back({static_cast<std::int64_t>(state_.iterations), wait});
        mark_loop(Region::Part::interlock);
        self().awaited_write(wait);
        pass(wait);
        mark_loop(Region::Part::iterations);
    }
    /// Less than so many iterations ago.
    bool is_within(std::int64_t iteration, std::uint64_t distance) const {
        return iteration + static_cast<std::int64_t>(distance) > static_cast<std::int64_t>(state_.iterations);
    }
    /// Those that are too many iterations ago for any span.
    void forget_write_waits() {
        std::vector<Cycles> const& spans = shape_->loops[state_.loop].interlock_spans;
        Cycles const longest_span = *std::max_element(spans.begin(), spans.end());
        auto const is_old = [&](auto const& before) { return !is_within(before.iteration, longest_span); };
        auto const old = std::remove_if(state_.write_waits.begin(), state_.write_waits.end(), is_old);
        state_.write_waits.erase(old, state_.write_waits.end());
    }

    // The pipelined loop.

    /// Iterations of the front operation, as many as can be done: true if the log is to be looked at again.
    bool do_iterations(Operation const& /*whole*/) {
        return plan_->aligned ? iterate_by_step(log_.front()) : iterate_in_pipeline(log_.front());
    }

    void enter(unsigned loop) {
        be_in_loop(loop + 1);
        state_.iterations = 0;
        state_.write_waits.clear();
        ++run_;
        self().entered();
        if (plan_->fill > 0)
            mark_loop(Region::Part::fill);
        pass(plan_->fill);
        mark_loop(Region::Part::iterations);
        begin_pipeline();
    }

    /// The next call goes on where the one before has begun its last iteration.
    void enter_again() {
        release_stamps();
        state_.rests = false;
        self().entered_again();
    }
    void release_stamps() {
        for (; state_.stamps_held > 0; --state_.stamps_held)
            self().stamped();
    }

    /// Lets the last tokens out, then moves to the end of the loop's last stage.
    bool leave() {
        PipelinePosition& pipeline = state_.pipeline;
        if (pipeline.drain_left == plan_->longest_lag && !pipeline.open)
            mark_loop(Region::Part::drain);
        for (; pipeline.drain_left > 0; --pipeline.drain_left)
            if (!pass_phases(0, false))
                return false;
        // The steps that draining walked through belong to the loop's depth, of which `drain` is the rest.
        state_.time += static_cast<Time>(plan_->drain - static_cast<std::int64_t>(plan_->longest_lag * plan_->ii));
        self().count_end();
        state_.in_loop = state_.rests = false;
        mark(Region());
        self().left();
        release_stamps();
        return true;
    }

    /// Of a loop that is not aligned: an iteration with accesses, or one of the silent ones behind it.
    bool iterate_in_pipeline(Operation& operation) {
        std::uint32_t& gap_left = state_.pipeline.gap_left;
        if (!pass_phases(gap_left > 0 ? Ports::Number{0} : operation.ports(), true))
            return false;
        gap_left = gap_left > 0 ? gap_left - 1 : operation.gap();
        count(1);
        if (gap_left == 0)
            take_off(operation, 1);
        return true;
    }

    /// What the iterations in the pipeline access in a phase of the one at hand.
    Ports ports_in(LoopPhase const& phase) const {
        Ports step;
        for (auto const& [port, lag] : phase.ports)
            if (state_.pipeline.iteration >= lag && Ports(state_.delayed(lag)).has(port))
                step = step | Ports::of(port);
        return step;
    }

    /// The II steps of an iteration that accesses `ports`, whose tokens leave in this or later iterations. False: it
    /// waits in one of them.
    bool pass_phases(Ports::Number ports, bool is_counted) {
        PipelinePosition& pipeline = state_.pipeline;
        if (!pipeline.open)
            open_iteration(ports, is_counted);
        else if (state_.delayed(0) != ports)  // part of which has been told
            state_.delayed(0) = (Ports(state_.delayed(0)) | Ports(ports)).number();
        if (!pass_phases_to(plan_->ii))
            return false;
        pass(plan_->ii - pipeline.offset);
        pipeline.open = false;
        ++pipeline.iteration;
        return true;
    }
    void open_iteration(Ports::Number ports, bool is_counted) {
        PipelinePosition& pipeline = state_.pipeline;
        bool const is_like_last = pipeline.iteration > 0 && state_.delayed(1) == ports;
        pipeline.alike = is_like_last ? pipeline.alike + 1 : 1;
        state_.delayed(0) = ports;
        pipeline.open = true;
        pipeline.counts = is_counted;
        pipeline.phase = 0;
        pipeline.offset = 0;
    }
    /// Those that are not behind a step of the iteration.
    bool pass_phases_to(Cycles last) {
        PipelinePosition& pipeline = state_.pipeline;
        for (; pipeline.phase < plan_->phases.size(); ++pipeline.phase) {
            LoopPhase const& phase = plan_->phases[pipeline.phase];
            if (phase.offset > last)
                return true;
            pass(phase.offset - pipeline.offset);
            pipeline.offset = phase.offset;
            Ports const step = ports_in(phase);
            if (!step.is_empty() && !perform(step.number()))
                return false;
            if (pipeline.phase == 0 && pipeline.counts)
                self().iterates(state_.iterations, 1);
        }
        return true;
    }

    // Aligned loops: all accesses of an iteration are one step.

    bool iterate_by_step(Operation& operation) {
        return operation.ports() == 0 ? pass_silence(operation) : iterate_in_step(operation);
    }

    bool pass_silence(Operation& operation) {
        std::uint64_t const iterations = std::uint64_t{operation.count()} * (1U + operation.gap());
        self().iterates(state_.iterations, iterations);
        pass(plan_->ii * iterations);
        count(iterations);
        take_off(operation, operation.count());
        return true;
    }

    bool iterate_in_step(Operation& operation) {
        if (!perform(operation.ports()))
            return false;
        std::uint64_t const iterations = 1U + operation.gap();
        self().iterates(state_.iterations, iterations);
        pass(plan_->ii * iterations);
        count(iterations);
        take_off(operation, 1);
        return true;
    }

  private:
    [[gnu::noinline]] void make_port_set(Ports::Number ports) const {
        if (ports >= sets_.size())
            sets_.resize(Ports::is_mask(ports) ? Ports::masks : Ports::numbers);
        auto set = std::make_unique<PortSet>();
        Ports(ports).each([&](unsigned number) { set->push_back(self().ports_[number]); });
        self().put_in_order(*set);
        sets_[ports] = std::move(set);
    }

    mutable std::vector<std::unique_ptr<PortSet>> sets_;  ///< by number; made when first needed
};

}  // namespace dataflow::timing
