#pragma once
#include <array>
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "kernel/base/cycles.hpp"
#include "kernel/base/source_site.hpp"
#include "kernel/timing/fifo_timing.hpp"
#include "kernel/timing/initiation_interval.hpp"
#include "kernel/timing/operation.hpp"
#include "kernel/timing/step_observer.hpp"
#include "kernel/timing/trail.hpp"

namespace faster::timing {

/// A FIFO written by a loop: the token of iteration i leaves in step i * II + write_latency.
struct LoopWrite {
    unsigned port = 0;
    Cycles write_latency = 0;  ///< Lw, below the loop's depth
};

/// One pipelined loop of a process (SPEC section 3).
struct LoopShape {
    std::string name;
    InitiationInterval interval;
    Cycles depth = 1;               ///< L
    std::vector<LoopWrite> writes;  ///< empty: the loop only reads, each iteration in its first step
    std::vector<unsigned> reads;    ///< ports read by a loop that writes as well, each iteration in its first step
};

struct LoopCounters {
    std::uint64_t entries = 0;  ///< with at least one iteration
    std::uint64_t iterations = 0;
    // What the last iterations of a loop shorter than its II would count too much.
    Cycles port_conflict_beyond_end = 0;
    Cycles recurrence_beyond_end = 0;
};

/// What leaving a loop adds to its counters.
struct LoopEnd {
    std::uint64_t entries = 0;
    Cycles port_conflict_beyond_end = 0;
    Cycles recurrence_beyond_end = 0;
};
/// After so many iterations; more than iterations_that_count() need not be told apart.
LoopEnd loop_end(LoopShape const& loop, std::uint64_t iterations);

/// What a loop cost its process, all entries together, besides an iteration each target interval.
struct LoopCost {
    Cycles port_conflict_cycles = 0;
    Cycles recurrence_cycles = 0;
    Cycles fill_drain_cycles = 0;
};

/// Gives every operation of one process its cycle. The local time T moves by what an operation takes and by waiting for
/// accesses to become legal; nothing else. The only place where the timing contract's step and pipelined loop live:
/// both engines drive it, `lockstep` one step at a time (front, commit_front), `decoupled` as far as it goes (advance).
class ProcessTiming {
  public:
    static constexpr unsigned most_accesses = 4;  ///< of an iteration of a loop whose tokens leave in one stage

    /// Accesses of a loop that share a sub-step of an iteration.
    struct Phase {
        Cycles offset = 0;                                      ///< steps after the iteration's first, below II
        std::vector<std::pair<unsigned, std::uint64_t>> ports;  ///< port, and iterations that its token is behind
    };
    /// How a loop's steps are laid out. `aligned`: all accesses of an iteration fall in one step, so that the pipeline
    /// needs no memory; otherwise the delay line holds what the last iterations have yet to write.
    struct LoopPlan {
        Cycles ii = 1;
        Cycles fill = 0;         ///< steps before the first access of the first iteration
        std::int64_t drain = 0;  ///< steps after the last iteration's II, in two's complement: may be negative
        bool aligned = true;
        std::uint64_t longest_lag = 0;  ///< iterations
        std::uint64_t counting = 1;     ///< iterations_that_count()
        std::vector<Phase> phases;
        std::vector<std::uint8_t> delay_line;  ///< port masks of the last iterations, a ring
    };

    enum class Status { exhausted, blocked, ready };
    /// Equal iterations from which on it pays to look for a steady state.
    static constexpr std::uint32_t long_count = 64;

    explicit ProcessTiming(std::string name, unsigned index) : name_(std::move(name)), index_(index) {}

    /// Ports in program order of a step. Return the port's number; at most 8.
    unsigned add_reads(FifoTiming& fifo);
    unsigned add_writes(FifoTiming& fifo);
    unsigned add_loop(LoopShape shape);

    /// Cycles of one setup, which is a wait of its own in statistics and on a critical path.
    void set_setup_cycles(Cycles cycles) { setup_cycles_ = cycles; }
    Cycles setup_cycles() const { return setup_cycles_; }
    /// What loops stood still for setups that had begun and were not done.
    Cycles awaited_setup_cycles() const { return awaited_setup_cycles_; }

    OperationLog& log() { return log_; }
    /// Logs besides log() that take down everything the process says.
    std::vector<OperationLog*> const& tapes() const { return tapes_; }
    bool is_taped() const { return is_taped_; }
    void add_tape(OperationLog& tape) {
        tapes_.push_back(&tape);
        is_taped_ = true;
    }
    void remove_tape(OperationLog& tape);

    /// Moves over everything that accesses nothing, up to the next step. `blocked`: an access of that step has no known
    /// earliest cycle yet, because the other side of its FIFO (blocking_port()) has not got there.
    Status front();
    /// The cycle in which the front step happens; front() said `ready`.
    Cycles front_cycle() const;
    std::uint8_t front_ports() const { return front_ports_; }
    void commit_front();

    /// Gives cycles to as many operations as possible. Returns the bits of the processes that may go on because of it.
    /// With `pause`, not beyond the next stamp.
    std::uint32_t advance(bool pause = false);
    /// Tells which process is at the other end of a port, as a bit for advance().
    void set_neighbour(unsigned port, std::uint32_t process_bit) { ports_[port].neighbour = process_bit; }

    /// In the middle of equal iterations, at least this many of which are left.
    bool is_running(std::uint32_t iterations) const {
        return (run_.active || is_in_equal_iterations()) && log_.front().kind() == Operation::Kind::iterate &&
               log_.front().count() >= iterations;
    }

    std::string const& name() const { return name_; }
    unsigned index() const { return index_; }
    Cycles local_time() const { return time_; }
    bool finished() const { return log_.exhausted(); }
    /// When the process reached the step it is at: its local time, but for the waiting it has been charged with since.
    Cycles waiting_since() const { return time_ == charged_until_ ? arrival_ : time_; }
    std::vector<Cycles> const& stamps() const { return stamps_; }
    Cycles empty_stall_cycles() const { return empty_stall_cycles_; }
    Cycles full_stall_cycles() const { return full_stall_cycles_; }
    LoopCost loop_cost(unsigned loop) const;
    /// More iterations than so many cost a loop no more at its end.
    static std::uint64_t iterations_that_count(LoopShape const& loop);
    /// What the process waited for its first access of all, if it had nothing to do before it; and the port.
    Cycles idle_before_cycles() const { return idle_before_cycles_; }
    unsigned first_port() const { return first_port_; }
    bool has_accessed() const { return has_accessed_; }

    /// From now on, goes step by step and tells the observer. Null: no longer.
    void set_observer(StepObserver* observer) {
        observer_ = observer;
        by_steps_ = observer != nullptr || !has_accessed_;
        run_.active = false;
    }
    /// From now on, tells what decides its times. Null: no longer.
    void set_trail(Trail* trail) { trail_ = trail; }
    Trail* trail() const { return trail_; }
    /// Continues from where another process of the same ports and loops stands, what it has logged included.
    void take_state(ProcessTiming const& other);
    bool in_loop() const { return in_loop_; }
    unsigned current_loop() const { return current_loop_; }
    std::uint64_t iterations() const { return iterations_; }
    std::size_t port_count() const { return ports_.size(); }
    FifoTiming& fifo(unsigned port) const { return *ports_[port].fifo; }
    bool writes(unsigned port) const { return ports_[port].writes; }
    std::vector<LoopShape> const& loops() const { return loops_; }
    LoopPlan const& plan(unsigned loop) const { return plans_[loop]; }
    LoopCounters const& loop_counters(unsigned loop) const { return loop_counters_[loop]; }
    /// The port that front() found blocked.
    unsigned blocking_port() const { return blocking_port_; }
    /// The port whose next token the process itself waits for before it can say what it does next; -1: none.
    int starving_port() const { return starving_port_; }
    void set_starving(int port) { starving_port_ = port; }
    /// Where the process is, for people: "scan, iteration 12".
    std::string position() const;
    /// Where in the source a loop begins, and where a port is accessed outside loops.
    void note_loop_site(unsigned loop, SourceSite const& site) { loop_sites_[loop] = site; }
    void note_site(std::uint8_t port, SourceSite const& site) {
        port_sites_[static_cast<unsigned>(__builtin_ctz(port))] = site;
    }
    SourceSite const& loop_site(unsigned loop) const { return loop_sites_[loop]; }
    SourceSite const& port_site(unsigned port) const { return port_sites_[port]; }
    /// Of what the process is at, which waits for a port.
    SourceSite site_at_hand(unsigned port) const { return in_loop_ ? loop_sites_[current_loop_] : port_sites_[port]; }

  private:
    static constexpr Cycles never = ~Cycles{0};
    static constexpr unsigned max_ports = 8;
    struct Port {
        FifoTiming* fifo;
        bool writes;
        std::uint32_t neighbour = 0;
        // For SteadyState: accesses before this one, in the run of this number, have nothing to wait for.
        std::uint64_t free_until = 0;
        std::uint64_t free_in_run = 0;
    };
    /// Where the process stands in an unaligned loop.
    struct PipelinePosition {
        std::uint64_t iteration = 0;
        bool open = false;  ///< inside an iteration
        std::size_t phase = 0;
        Cycles offset = 0;
        std::uint32_t gap_left = 0;
        std::uint64_t drain_left = 0;
    };

    /// The ports that an iteration of an aligned loop accesses, all in one direction.
    struct PortSet {
        std::uint8_t mask = 0;
        unsigned size = 0;
        FifoTiming* fifos[4] = {};
        unsigned ports[4] = {};
        bool writes = false;
        std::uint32_t neighbours = 0;
        std::uint32_t (ProcessTiming::*accesses)(PortSet const& set, std::uint32_t count, Cycles stride) = nullptr;
        std::uint32_t (ProcessTiming::*mixed_accesses)(PortSet const& set, unsigned length,
                                                       std::uint32_t gaps) = nullptr;
        std::uint32_t (ProcessTiming::*accesses_with_tails)(PortSet const& set, Operation const& operation) = nullptr;
    };
    /// Iterations of an aligned loop that all access the same ports: the hot path.
    struct Run {
        bool active = false;
        std::uint64_t number = 0;
        PortSet const* ports = nullptr;
        Cycles stride = 1;  ///< cycles from one access to the next, if that is always the same
    };

    unsigned add_port(FifoTiming& fifo, bool writes);
    void move(std::int64_t cycles) { time_ += static_cast<Cycles>(cycles); }
    LoopPlan& plan() { return plans_[current_loop_]; }
    bool find_step();
    bool find_step_in_iterations(Operation& operation);
    bool find_step_in_pipeline(std::uint8_t ports);
    bool find_step_while_draining();
    void open_iteration(std::uint8_t ports);
    void enter_loop(unsigned loop);
    void count_loop();
    void perform(std::uint8_t ports);
    void mark(Region region, Cycles from) {
        if (trail_ != nullptr)
            trail_->marked(index_, region, from);
    }
    void set_up();
    void prepare(Operation const& operation);
    void await_setup();
    void leave_trail(unsigned port);
    void note_first_access(std::uint8_t ports, Cycles arrival);
    void end_iterations(Operation& operation, std::uint32_t count) {
        count_iterations(std::uint64_t{count} * (1U + operation.gap()));
        take_off(operation, count);
    }
    void count_iterations(std::uint64_t iterations) {
        iterations_ += iterations;
        loop_counters_[current_loop_].iterations += iterations;
    }
    void take_off(Operation& operation, std::uint32_t count) {
        operation.subtract(count);
        if (operation.count() > 0)
            return;
        if (operation.tail_ports() != 0)
            operation.become_tail();
        else
            log_.consume();
    }
    bool skip_silent_iterations();
    /// Of an unaligned loop.
    bool is_in_equal_iterations() const {
        return in_loop_ && !by_steps_ && !plans_[current_loop_].aligned && !log_.exhausted() &&
               log_.front().kind() == Operation::Kind::iterate && log_.front().ports() != 0;
    }
    PortSet const& port_set(std::uint8_t ports);
    PortSet make_port_set(std::uint8_t ports) const;
    void start_run(Operation const& operation);
    bool continue_run();
    bool continue_plain_run();
    bool continue_mix();
    bool goes_on_with_mix(Operation& mix);
    static bool is_line(Operation const& operation);
    bool continue_with_tails();
    void end_iterations_with_tails(Operation const& operation, std::uint32_t done);
    static std::uint32_t length_with_tails(Operation const& operation);
    static std::uint32_t reachable_with_tails(Operation const& operation, std::uint64_t known,
                                              std::uint64_t known_of_tails);
    template <unsigned N, bool Writes> class Burst;
    template <unsigned N, bool Writes>
    bool has_nothing_to_wait_for(PortSet const& set, std::uint64_t whole, std::uint64_t all) const;
    template <unsigned N, bool Writes>
    std::uint32_t accesses_with_tails(PortSet const& set, Operation const& operation);
    template <unsigned N, bool Writes>
    void free_accesses_with_tails(PortSet const& set, Operation const& operation, std::uint32_t end,
                                  std::uint32_t whole);
    template <unsigned N, bool Writes>
    void waiting_accesses_with_tails(PortSet const& set, Operation const& operation, std::uint32_t end);
    template <unsigned N, bool Writes> std::uint32_t accesses(PortSet const& set, std::uint32_t count, Cycles stride);
    template <unsigned N, bool Writes>
    std::uint32_t mixed_accesses(PortSet const& set, unsigned length, std::uint32_t gaps);
    template <unsigned N, bool Writes, class Stride>
    std::uint32_t run_accesses(PortSet const& set, std::uint64_t count, Stride const& stride);
    template <unsigned N, bool Writes, class Stride>
    void free_accesses(PortSet const& set, std::uint64_t count, Stride const& stride);

    std::string name_;
    unsigned index_;
    std::vector<Port> ports_;
    std::vector<LoopShape> loops_;
    std::vector<LoopPlan> plans_;
    std::vector<LoopCounters> loop_counters_;
    OperationLog log_;
    bool is_taped_ = false;
    std::vector<OperationLog*> tapes_;
    std::vector<SourceSite> loop_sites_;
    std::array<SourceSite, 8> port_sites_{};
    Cycles time_ = 0;
    Cycles empty_stall_cycles_ = 0;
    Cycles full_stall_cycles_ = 0;
    Cycles setup_cycles_ = 0;
    std::deque<Cycles> setups_done_;  ///< when those begun, and not awaited yet, will be
    Cycles awaited_setup_cycles_ = 0;
    StepObserver* observer_ = nullptr;
    Trail* trail_ = nullptr;
    bool by_steps_ = true;  ///< until the first access; always when observed
    bool has_accessed_ = false;
    Cycles idle_before_cycles_ = 0;
    unsigned first_port_ = 0;
    std::vector<Cycles> stamps_;
    Cycles arrival_ = 0;
    Cycles charged_until_ = never;

    std::uint8_t front_ports_ = 0;  ///< accesses of the step at hand; 0: none found yet
    unsigned blocking_port_ = 0;
    int starving_port_ = -1;
    unsigned current_loop_ = 0;
    bool in_loop_ = false;
    std::uint64_t iterations_ = 0;  ///< of the loop entry at hand
    std::uint64_t loops_entered_ = 0;
    Run run_;
    std::vector<PortSet> port_sets_;  ///< made when first needed
    PipelinePosition pipeline_;
    std::uint64_t pipeline_run_ = 0;  ///< number of the operation at hand in an unaligned loop
    friend class SteadyState;
    friend class RelativeState;
};

}  // namespace faster::timing
