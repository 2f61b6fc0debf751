#pragma once
#include <algorithm>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <vector>

#include "kernel/timing/fifo_rules.hpp"
#include "kernel/timing/flushing_pipeline.hpp"
#include "kernel/timing/operation.hpp"
#include "kernel/timing/ports.hpp"
#include "kernel/timing/process_shape.hpp"
#include "kernel/timing/trail.hpp"

namespace faster::timing {

/// Where a process stands in a loop whose tokens leave in different stages.
struct PipelinePosition {
    std::uint64_t iteration = 0;
    bool open = false;           ///< inside an iteration
    std::size_t phase = 0;       ///< the one at hand
    Cycles offset = 0;           ///< steps since the iteration's first
    std::uint32_t gap_left = 0;  ///< silent iterations behind one with accesses
    std::uint64_t drain_left = 0;
    std::uint64_t alike = 0;  ///< of the last iterations begun, at least so many have accessed the same ports
};

/// Where a process stands. With the operations that it has yet to do and the FIFOs around it, all that decides when it
/// does what.
template <class Time> struct ProcessState {
    Time time = 0;  ///< T of SPEC section 3
    bool in_loop = false;
    unsigned loop = 0;             ///< that it is in, or was in last
    std::uint64_t iterations = 0;  ///< of the loop entry at hand
    PipelinePosition pipeline;
    std::vector<Ports::Number> delay_line;  ///< ports of the last iterations of a loop that is not aligned, a ring
    std::vector<Time> setups_done;          ///< when those begun, and not awaited yet, will be
    /// Steps in which a loop has begun nothing, as an iteration waited for a write: before which. The latest ones.
    struct Bubbles {
        std::uint64_t iteration = 0;
        Cycles steps = 0;
    };
    std::vector<Bubbles> bubbles;
    FlushingPipeline<Time> flushing;

    /// What an iteration of a loop accesses, `lag` iterations before the one at hand.
    Ports::Number delayed(std::uint64_t lag) const { return delay_line[place(pipeline.iteration - lag)]; }
    Ports::Number& delayed(std::uint64_t lag) { return delay_line[place(pipeline.iteration - lag)]; }

  private:
    std::size_t place(std::uint64_t iteration) const { return iteration & (delay_line.size() - 1); }
};

/// The rules of time of a process (SPEC section 3): the step, the pipelined loop with its delay line, the setup, the
/// steps of a flushing pipeline. This is the only place that states them. The local time moves by what an operation
/// takes and by waiting for accesses to become legal; nothing else.
///
/// `Process`, which derives from this, knows the FIFOs at its ports and counts what happens. `Port` has a number and an
/// end of a FIFO, and so decides how cycles are held (see FifoRules), and with them the local time. `Process` has
///
///     std::vector<Port> ports_                      in program order of a step
///     bool goes_by_steps() const                    true: iterations one by one, so that each can be looked at
///     bool may_go_on()                              false: stops in front of the next access, whatever it is
///     bool may_access(Ports::Number ports)           the same of a single step
///     void wait_for(Port const&)                    stops, as the earliest cycle of an access there is not known
///     void charge(Port const&, Time stall)          has waited so long, up to the local time, for an access
///     void performs(Ports::Number ports, Time arrival)  a step takes place at the local time
///     void note(Port const&, std::uint64_t count)   so many accesses have been entered in the FIFO
///     void count(std::uint64_t iterations)          of the loop it is in
///     void iterates(std::uint64_t first, std::uint64_t count)  they begin at the local time
///     void entered(), count_end(), left()           a loop
///     void awaited_setup(Time cycles), awaited_write(Cycles cycles), stamped()
///     void let_bubbles_in(Port const&, Time bubbles, Time from)  a flushing pipeline, instead of what a port reads
///     void lets_out(Port const&, Time due, Time cycle)  a token, which may have waited; told before the access
///     void waits_for_room(Port const&)  for a token in a flushing pipeline, whatever else it waits for
template <class Process, class Port> class ProcessRules {
  public:
    using Line = typename Port::Line;
    using Time = typename Line::Time;
    static constexpr unsigned most_in_run = 4;  ///< ports of iterations that are done many at a time
    /// Equal iterations from which on it pays to look for a steady state.
    static constexpr std::uint32_t long_count = 64;

    ProcessState<Time> const& state() const { return state_; }
    OperationLog const& log() const { return log_; }
    /// Nothing is left to be done, nor in its flushing pipeline.
    bool finished() const { return log_.exhausted() && !state_.flushing.is_waiting(); }
    bool flushes() const { return shape_->flushing_stages > 0; }
    bool in_loop() const { return state_.in_loop; }
    /// In an iteration whose steps are not all over.
    bool is_in_iteration() const {
        bool const drains = !log_.exhausted() && log_.begin()->kind() == Operation::Kind::leave;
        return state_.in_loop && state_.pipeline.open && !drains;
    }
    LoopPlan const& plan() const { return *plan_; }
    /// The accesses of the step that a process has stopped in front of which goes step by step.
    Ports step_at_hand() const {
        bool const is_in_pipeline = state_.in_loop && !plan_->aligned && state_.pipeline.open;
        return is_in_pipeline ? ports_in(plan_->phases[state_.pipeline.phase]) : Ports(log_.front().ports());
    }
    /// No access to come is before this cycle: the local time, less what the process goes back when it leaves a loop
    /// whose last tokens are out before the last initiation interval is over.
    Time not_before() const {
        return state_.in_loop ? state_.time + static_cast<Time>(std::min<std::int64_t>(plan_->drain, 0)) : state_.time;
    }

    /// What it has yet to read and to write must be told. Not of a loop that takes from memory: see alike_iterations().
    bool has_delay_line() const { return state_.in_loop && !plan_->aligned && !is_in_memory_loop(); }
    bool is_in_memory_loop() const { return state_.in_loop && shape_->loops[state_.loop].uses_memory; }
    /// Iterations at hand of a loop that takes from memory, if all that are in its pipeline access what they do: as
    /// long as what they take is there, each does what an iteration does of a loop that takes nothing.
    std::uint32_t alike_iterations() const {
        if (log_.exhausted() || !is_in_memory_loop())
            return 0;
        Operation const& operation = log_.front();
        bool const is_plain = operation.kind() == Kind::iterate && operation.own_tail_ports() == 0;
        return is_plain && is_uniform(operation) ? operation.count() : 0;
    }

    /// Takes up where another state has left a process: its loop, from 1 on, or 0, and how many iterations have begun.
    /// What it has yet to write is a delay line, from the latest iteration on. Of a loop that takes from memory only
    /// the time.
    void restore(Time time, unsigned loop, std::uint64_t iterations) {
        state_.time = time;
        ++run_;
        if (is_in_memory_loop())
            return;
        state_.iterations = iterations;
        be_in_loop(loop);
        if (!state_.in_loop)
            return;
        begin_pipeline();
        state_.pipeline.iteration = plan_->longest_lag;
    }
    void restore_delayed(std::uint64_t lag, Ports::Number ports) { state_.delayed(lag) = ports; }
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
        switch (operation.kind()) {
            case Kind::wait:
                if (!operation.is_plain_wait())
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
                enter(operation.count());
                break;
            case Kind::leave:
                if (!leave())
                    return false;
                break;
            case Kind::stamp:
                self().stamped();
                break;
            case Kind::iterate:
            case Kind::mixed:
            case Kind::flanked:
                return plan_->aligned ? iterate(operation) : iterate_in_pipeline(log_.front());
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
        bool const drains = !log_.exhausted() && log_.begin()->kind() == Kind::leave;
        return Region::of_loop(state_.loop, drains ? Region::Part::drain : Region::Part::iterations);
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
    /// In the pipeline, which is full of iterations that access the same ports.
    void go_on_alike(Ports::Number ports, std::uint64_t iterations) {
        state_.pipeline.iteration += iterations;
        state_.pipeline.alike += iterations;
        for (std::uint64_t lag = std::min(iterations, plan_->longest_lag); lag > 0; --lag)
            state_.delayed(lag) = ports;
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

  private:
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
        } else {
            mark(Region::setup());
            pass(cycles * operation.count());
            mark(Region());
        }
    }
    void await_setup() {
        Time const done = state_.setups_done.front();
        state_.setups_done.erase(state_.setups_done.begin());
        if (done <= state_.time)
            return;
        mark(Region::setup());
        self().awaited_setup(done - state_.time);
        state_.time = done;
        mark_loop(Region::Part::iterations);
    }

    /// A frozen pipeline keeps its iterations as many steps apart as they were begun: II, and the bubbles in between.
    /// Nothing else decides how long one waits.
    void await_write(std::uint32_t dependence, std::uint64_t distance) {
        std::vector<Cycles> const& spans = shape_->loops[state_.loop].interlock_spans;
        Cycles steps = distance * plan_->ii;
        for (auto const& bubbles : state_.bubbles)
            if (bubbles.iteration + distance > state_.iterations)
                steps += bubbles.steps;
        if (steps >= spans[dependence])
            return;
        Cycles const wait = spans[dependence] - steps;
        forget_bubbles(*std::max_element(spans.begin(), spans.end()));
        state_.bubbles.push_back({state_.iterations, wait});
        mark_loop(Region::Part::interlock);
        self().awaited_write(wait);
        pass(wait);
        mark_loop(Region::Part::iterations);
    }
    /// Those that are too many iterations ago for any span.
    void forget_bubbles(Cycles longest_span) {
        auto const is_old = [&](auto const& bubbles) { return bubbles.iteration + longest_span <= state_.iterations; };
        auto const old = std::remove_if(state_.bubbles.begin(), state_.bubbles.end(), is_old);
        state_.bubbles.erase(old, state_.bubbles.end());
    }

    // The pipelined loop.

    void enter(unsigned loop) {
        be_in_loop(loop + 1);
        state_.iterations = 0;
        state_.bubbles.clear();
        ++run_;
        self().entered();
        if (plan_->fill > 0)
            mark_loop(Region::Part::fill);
        pass(plan_->fill);
        mark_loop(Region::Part::iterations);
        begin_pipeline();
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
        state_.in_loop = false;
        mark(Region());
        self().left();
        return true;
    }

    /// Of a loop that is not aligned: an iteration with accesses, or one of the silent ones behind it.
    bool iterate_in_pipeline(Operation& operation) {
        if (is_uniform(operation))
            return run_in_pipeline(operation);
        std::uint32_t& gap_left = state_.pipeline.gap_left;
        if (!pass_phases(gap_left > 0 ? Ports::Number{0} : operation.ports(), true))
            return false;
        gap_left = gap_left > 0 ? gap_left - 1 : operation.gap();
        count(1);
        if (gap_left == 0)
            take_off(operation, 1);
        return true;
    }

    /// Of a loop that takes from memory, which is in no group of the lookups: all iterations in the pipeline access
    /// what the next ones do, in one step of each. So every step does the same.
    bool is_uniform(Operation const& operation) const {
        PipelinePosition const& pipeline = state_.pipeline;
        if (!shape_->loops[state_.loop].uses_memory || plan_->phases.size() != 1 || plan_->phases.front().offset > 0 ||
            self().goes_by_steps() || pipeline.open || pipeline.gap_left > 0 || operation.gap() > 0 ||
            operation.ports() == 0 || operation.count() < 2 || pipeline.alike < plan_->longest_lag)
            return false;
        bool const goes_on = plan_->longest_lag == 0 || state_.delayed(1) == operation.ports();
        return goes_on && are_in_one_step(operation.ports());
    }

    /// Of a loop with one step.
    bool are_in_one_step(Ports::Number ports) const {
        std::size_t const all = port_set(ports).size();
        auto const& known = plan_->phases.front().ports;
        return all <= most_in_run &&
               all == static_cast<std::size_t>(std::count_if(known.begin(), known.end(), [ports](auto const& port) {
                   return Ports(ports).has(port.first);
               }));
    }

    bool run_in_pipeline(Operation& operation) {
        std::uint32_t const wanted = operation.count();
        Time const stride = static_cast<Time>(plan_->ii);
        std::uint32_t const done =
            run(port_set(operation.ports()), wanted, [stride](std::uint32_t /*i*/) { return stride; });
        if (done == 0)
            return false;
        go_on_alike(operation.ports(), done);
        count(done);
        take_off(operation, done);
        return done == wanted;
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
        if (!pipeline.open) {
            if (is_counted)
                self().iterates(state_.iterations, 1);
            bool const is_like_last = pipeline.iteration > 0 && state_.delayed(1) == ports;
            pipeline.alike = is_like_last ? pipeline.alike + 1 : 1;
            state_.delayed(0) = ports;
            pipeline.open = true;
            pipeline.phase = 0;
            pipeline.offset = 0;
        }
        for (; pipeline.phase < plan_->phases.size(); ++pipeline.phase) {
            LoopPhase const& phase = plan_->phases[pipeline.phase];
            pass(phase.offset - pipeline.offset);
            pipeline.offset = phase.offset;
            Ports const step = ports_in(phase);
            if (!step.is_empty() && !perform(step.number()))
                return false;
        }
        pass(plan_->ii - pipeline.offset);
        pipeline.open = false;
        ++pipeline.iteration;
        return true;
    }

    // Aligned loops: all accesses of an iteration are one step.

    bool iterate(Operation const& whole) {
        bool const by_steps = self().goes_by_steps() || port_set(whole.ports()).size() > most_in_run;
        if (!by_steps && whole.kind() == Kind::mixed)
            return run_mix(whole);
        if (!by_steps && is_line(whole))
            return run_line(whole);
        Operation& operation = log_.front();
        if (operation.ports() == 0)
            return pass_silence(operation);
        return by_steps ? iterate_by_step(operation) : run_iterations(operation);
    }

    bool pass_silence(Operation& operation) {
        std::uint64_t const iterations = std::uint64_t{operation.count()} * (1U + operation.gap());
        self().iterates(state_.iterations, iterations);
        pass(plan_->ii * iterations);
        count(iterations);
        take_off(operation, operation.count());
        return true;
    }

    bool iterate_by_step(Operation& operation) {
        if (!perform(operation.ports()))
            return false;
        std::uint64_t const iterations = 1U + operation.gap();
        self().iterates(state_.iterations, iterations);
        pass(plan_->ii * iterations);
        count(iterations);
        take_off(operation, 1);
        return true;
    }

    bool run_iterations(Operation& operation) {
        Time const stride = static_cast<Time>(plan_->ii * (1U + operation.gap()));
        std::uint32_t const wanted = operation.count();
        std::uint32_t const done =
            run(port_set(operation.ports()), wanted, [stride](std::uint32_t /*i*/) { return stride; });
        if (done == 0)
            return false;
        count(std::uint64_t{done} * (1U + operation.gap()));
        take_off(operation, done);
        return done == wanted;
    }

    bool run_mix(Operation const& mix) {
        auto const interval = static_cast<Time>(plan_->ii);
        std::uint32_t const gaps = mix.gaps();
        std::uint32_t const done = run(port_set(mix.ports()), mix.length(), [interval, gaps](std::uint32_t i) {
            return ((gaps >> i) & 1U) != 0 ? 2 * interval : interval;
        });
        if (done == 0)
            return false;
        std::uint32_t const silent = gaps & Operation::gap_bits(1, done);
        count(done + (silent != 0 ? static_cast<std::uint64_t>(__builtin_popcount(silent)) : 0));
        bool const is_over = done == mix.length();
        log_.consume(is_over ? 1 : 0, is_over ? 0 : done);
        return is_over;
    }

    /// Iterations of which all earliest cycles are known, one after the other. Each accesses all ports of a set, or is
    /// a tail that accesses only the last.
    template <unsigned N> class Burst {
      public:
        Burst(ProcessRules& process, PortSet const& set, std::uint64_t whole, std::uint64_t all)
            : process_(process), set_(set), time_(process.state_.time) {
            for (unsigned i = 0; i < N; ++i) {
                FifoEnd<Line> const& end = set[i].end;
                earliest_[i] = end.consumes->reader();
                appended_[i] = end.appends->writer(i + 1 < N ? whole : all);
                later_[i] = end.later;
            }
        }

        /// Whether any of the accesses to come may have to wait: those of a FIFO never become legal earlier than the
        /// one before.
        bool may_wait(std::uint64_t whole, std::uint64_t all) const {
            bool waits = whole == 0;
            for (unsigned i = 0; i < N && !waits; ++i)
                waits = earliest_[i][(i + 1 < N ? whole : all) - 1] > time_;
            return waits;
        }

        /// The next iteration is `stride` cycles after this one.
        template <bool MayWait> [[gnu::always_inline]] void iterate(bool is_tail, Time stride) {
            unsigned waited_for = N;
            Time const arrival = time_;
            for (unsigned i = is_tail ? N - 1 : 0; MayWait && i < N; ++i) {
                Time const later = std::max<Time>(earliest_[i][accesses_of(i)], time_);
                stalls_[i] += later - time_;
                waited_for = later > time_ ? i : waited_for;
                time_ = later;
            }
            if (process_.trail_ != nullptr && waited_for < N)
                process_.self().note_wait(set_[waited_for],
                                          Region::of_loop(process_.state_.loop, Region::Part::iterations), 0, arrival,
                                          time_);
            for (unsigned i = is_tail ? N - 1 : 0; i < N; ++i)
                appended_[i][accesses_of(i)] = static_cast<typename Line::Cycle>(time_ + later_[i]);
            whole_ += is_tail ? 0 : 1;
            ++all_;
            time_ += stride;
        }

        void end() {
            process_.state_.time = time_;
            for (unsigned i = 0; i < N; ++i) {
                Port const& port = set_[i];
                std::uint64_t const accesses = accesses_of(i);
                if (accesses > 0) {
                    port.end.consumes->consume(accesses);
                    port.end.appends->done(accesses);
                    process_.self().note(port, accesses);
                }
                if (stalls_[i] > 0)
                    process_.self().charge(port, stalls_[i]);
            }
        }

      private:
        std::uint64_t accesses_of(unsigned port) const { return port + 1 < N ? whole_ : all_; }

        ProcessRules& process_;
        PortSet const& set_;
        typename Line::Reader earliest_[N];
        typename Line::Writer appended_[N];
        Time later_[N];
        Time stalls_[N] = {};
        Time time_;
        std::uint64_t whole_ = 0;  ///< iterations that were no tails
        std::uint64_t all_ = 0;
    };

    static std::uint64_t known(PortSet const& set, std::size_t ports) {
        std::uint64_t known = ~std::uint64_t{0};
        for (std::size_t i = 0; i < ports; ++i)
            known = std::min(known, set[i].end.known());
        return known;
    }
    /// For the first port of which no more are known.
    void wait_behind(PortSet const& set, std::uint64_t known) {
        for (Port const& port : set)
            if (port.end.known() <= known) {
                self().wait_for(port);
                return;
            }
    }

    /// Up to `wanted` iterations that access all ports of a set, as long as their earliest cycles are known: how many.
    template <class Stride> std::uint32_t run(PortSet const& set, std::uint32_t wanted, Stride const& stride) {
        std::uint64_t const known_of_all = known(set, set.size());
        if (known_of_all < wanted) {
            wait_behind(set, known_of_all);
            wanted = static_cast<std::uint32_t>(known_of_all);
        }
        if (wanted == 0 || !self().may_go_on())
            return 0;
        switch (set.size()) {
            case 1:
                run<1>(set, wanted, stride);
                break;
            case 2:
                run<2>(set, wanted, stride);
                break;
            case 3:
                run<3>(set, wanted, stride);
                break;
            default:
                run<most_in_run>(set, wanted, stride);
                break;
        }
        return wanted;
    }
    template <unsigned N, class Stride> void run(PortSet const& set, std::uint32_t wanted, Stride const& stride) {
        Burst<N> burst(*this, set, wanted, wanted);
        auto const run = [&](auto may_wait) {
            for (std::uint32_t k = 0; k < wanted; ++k)
                burst.template iterate<decltype(may_wait)::value>(false, stride(k));
        };
        burst.may_wait(wanted, wanted) ? run(std::true_type()) : run(std::false_type());
        burst.end();
    }

    // Lines: iterations with tails that access the last of their ports, in one piece.

    /// The longest are done as iterations, so that a steady state is seen.
    static bool is_line(Operation const& operation) {
        bool const is_long = operation.kind() == Kind::iterate && operation.count() >= long_count;
        return operation.has_last_port_as_tail() && !is_long;
    }
    /// Iterations that access something.
    static std::uint32_t length_of_line(Operation const& line) {
        return line.count() + (line.kind() == Kind::flanked ? 2U : 1U);
    }
    /// How many of them can be done if the ports of whole ones let `known` be done, and the tails' port so many of all.
    static std::uint32_t reachable(Operation const& line, std::uint64_t known, std::uint64_t known_of_tails) {
        bool const is_flanked = line.kind() == Kind::flanked;
        std::uint64_t const length = length_of_line(line);
        std::uint64_t const whole = length - (is_flanked ? 2 : 1);
        std::uint64_t const reachable = known >= whole ? length : known + (is_flanked && known > 0 ? 1 : 0);
        return static_cast<std::uint32_t>(std::min(reachable, known_of_tails));
    }
    static std::uint32_t tails_of(Operation const& line, std::uint32_t done) {
        return (done == length_of_line(line) ? 1U : 0U) + (line.kind() == Kind::flanked && done > 1 ? 1U : 0U);
    }

    bool run_line(Operation const& line) {
        PortSet const& set = port_set(line.ports());
        std::size_t const ports = set.size();
        std::uint64_t const known_of_whole = known(set, ports - 1);
        std::uint32_t const done = reachable(line, known_of_whole, set.back().end.known());
        bool const is_over = done == length_of_line(line);
        if (!is_over)
            wait_behind(set, std::min<std::uint64_t>(known_of_whole, done));
        if (done == 0 || !self().may_go_on())
            return false;
        switch (ports) {
            case 2:
                run_line<2>(set, line, done);
                break;
            case 3:
                run_line<3>(set, line, done);
                break;
            default:
                run_line<most_in_run>(set, line, done);
                break;
        }
        end_line(line, done);
        return is_over;
    }

    template <unsigned N> void run_line(PortSet const& set, Operation const& line, std::uint32_t count) {
        std::uint32_t const last = length_of_line(line) - 1;
        std::uint32_t const other_tail = line.kind() == Kind::flanked ? 1 : last;
        auto const interval = static_cast<Time>(plan_->ii);
        std::uint32_t const whole = count - tails_of(line, count);
        Burst<N> burst(*this, set, whole, count);
        auto const run = [&](auto may_wait) {
            for (std::uint32_t k = 0; k < count; ++k) {
                bool const is_tail = k == last || k == other_tail;
                std::uint32_t const silent = k == last ? line.tail_gap() : is_tail ? 0U : line.gap();
                burst.template iterate<decltype(may_wait)::value>(is_tail, interval * static_cast<Time>(1U + silent));
            }
        };
        burst.may_wait(whole, count) ? run(std::true_type()) : run(std::false_type());
        burst.end();
    }

    /// Counts the iterations done, and leaves the others in the log.
    void end_line(Operation const& line, std::uint32_t done) {
        bool const is_flanked = line.kind() == Kind::flanked;
        bool const is_over = done == length_of_line(line);
        count(done + std::uint64_t{done - tails_of(line, done)} * line.gap() + (is_over ? line.tail_gap() : 0U));
        ++run_;
        if (is_over) {
            log_.consume();
            return;
        }
        std::uint32_t const of_rest = is_flanked ? done - std::min(done, 2U) : done;
        log_.whole_front() = is_flanked ? line.rest() : line;
        if (of_rest > 0)
            log_.consume(0, of_rest);
        if (is_flanked && done == 1)
            log_.put_back(Operation(Kind::iterate, line.tail_ports(), 0, 1));
    }

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

}  // namespace faster::timing
