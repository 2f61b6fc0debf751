#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "dataflow/base/cycles.hpp"
#include "dataflow/base/source_site.hpp"
#include "dataflow/core/time/access_sites.hpp"
#include "dataflow/core/time/bulk_runs.hpp"
#include "dataflow/core/time/fifo_timing.hpp"
#include "dataflow/core/time/operation_log.hpp"
#include "dataflow/core/time/process_shape.hpp"
#include "dataflow/core/time/step_observer.hpp"
#include "dataflow/core/time/trail.hpp"

namespace dataflow::timing {

class MemoryStream;

struct LoopCounters {
    std::uint64_t entries = 0;  ///< with at least one iteration
    std::uint64_t iterations = 0;
    // What the last iterations of a loop shorter than its II would count too much.
    Cycles port_conflict_beyond_end = 0;
    Cycles recurrence_beyond_end = 0;
    Cycles interlock_cycles = 0;  ///< in which iterations waited for others to write
};

/// What a loop cost its process, all entries together, besides an iteration each target interval.
struct LoopCost {
    Cycles port_conflict_cycles = 0;
    Cycles recurrence_cycles = 0;
    Cycles fill_drain_cycles = 0;
};

/// A port of a process of a core.
struct ProcessPort {
    using Line = CycleRing;

    FifoTiming::End end;
    unsigned number = 0;
    FifoTiming* fifo = nullptr;
    bool writes = false;
    ProcessMask neighbour = 0;  ///< the process at the other end, as a bit
};

/// What is known of a loop's module.
struct LoopNotes {
    AccessSites sites;  ///< where it enters the loop
    Ports first;        ///< it reads them as the first thing of an iteration, and does nothing else until then
    Ports ends;         ///< it takes what they read later, and goes on until it says otherwise
};

/// What happened in one process of a core.
struct ProcessFigures {
    Cycles empty_stall_cycles = 0;
    Cycles full_stall_cycles = 0;
    Cycles memory_stall_cycles = 0;
    Cycles awaited_setup_cycles = 0;
    Cycles idle_before_cycles = 0;
    std::vector<Cycles> waits_before;  ///< by port: before the first access
    /// By port, behind attempts that have found nothing and no access since: the cycle after the last; 0: none.
    std::vector<Cycles> failed_before;
    bool has_accessed = false;
    std::uint64_t loops_entered = 0;
    std::vector<LoopCounters> loops;
    std::vector<Cycles> stamps;
    std::vector<Cycles> next_calls;  ///< by stamp, where they end samples: when the next call of the process begins
    /// What it waited for last, some of which may lie beyond the end of the run, and up to when, if that is known: not
    /// in many iterations at once. A ring.
    struct Wait {
        unsigned port = 0;
        Cycles cycles = 0;
        Cycles until = 0;
    };
    std::array<Wait, 4> latest_waits{};
    unsigned waits = 0;
};

/// Gives every operation of one process of a core its cycle, by ProcessRules and BulkRuns, and counts what happens.
/// Both engines drive it: `lockstep` stops in front of each step (front, commit_front), `decoupled` goes as far as it
/// can (advance).
class ProcessTiming : private BulkRuns<ProcessTiming, ProcessPort> {
  public:
    using Rules = BulkRuns<ProcessTiming, ProcessPort>;
    using Rules::alike_iterations;
    using Rules::finished;
    using Rules::flushes;
    using Rules::in_loop;
    using Rules::is_in_iteration;
    using Rules::long_count;
    using Rules::rests;

    enum class Status { exhausted, blocked, ready };

    explicit ProcessTiming(std::string name, unsigned index,
                           std::shared_ptr<ProcessShape> shape = std::make_shared<ProcessShape>());

    /// Ports in program order of a step. Return the port's number.
    unsigned add_reads(FifoTiming& fifo) { return add_port(fifo, false); }
    unsigned add_writes(FifoTiming& fifo) { return add_port(fifo, true); }
    /// The process's stream; a step accesses it before all else, though its port's number is the last.
    unsigned add_stream(MemoryStream& stream);
    MemoryStream* stream() const { return stream_; }
    unsigned stream_port() const { return stream_port_; }
    unsigned add_loop(LoopShape shape);

    /// Cycles of one setup, which is a wait of its own in statistics and on a critical path.
    void set_setup_cycles(Cycles cycles) { shape_->setup_cycles = cycles; }
    void set_call_start(CallStart start) { shape_->call_start = start; }
    /// Stamps note the last cycle that has passed, instead of the one to come.
    void let_stamps_look_back(bool look_back) { shape_->stamps_back = look_back ? 1 : 0; }
    /// What loops stood still for setups that had begun and were not done.
    Cycles awaited_setup_cycles() const { return figures_.awaited_setup_cycles; }

    OperationLog& log() { return log_; }
    OperationLog const& log() const { return log_; }
    /// Logs besides log() that take down everything the process says.
    std::vector<OperationLog*> const& tapes() const { return tapes_; }
    /// Nothing more will be logged: a loop that rewinds does not go on. In a log, its own or one for that.
    void tell_end() { tell_end(log_); }
    void tell_end(OperationLog& log) const;
    bool is_taped() const { return is_taped_; }
    void add_tape(OperationLog& tape) {
        tapes_.push_back(&tape);
        is_taped_ = true;
    }
    void remove_tape(OperationLog& tape);

    /// Goes up to the next step, and stops in front of it. `blocked`: an access of that step has no known earliest
    /// cycle yet, because the other side of its FIFO (blocking_port()) has not got there.
    Status front();
    /// The cycle in which the front step happens; front() said `ready`.
    Cycles front_cycle() const;
    Ports front_ports() const { return front_ports_; }
    /// Steps from the begin of the first iteration of the loop that it is in to the one that front() stopped at.
    Cycles front_step() const {
        PipelinePosition const& pipeline = state_.pipeline;
        return plan_->fill - loops()[state_.loop].entry_states +
               (plan_->aligned ? state_.iterations * plan_->ii : pipeline.iteration * plan_->ii + pipeline.offset);
    }
    void commit_front();

    /// Gives cycles to as many operations as possible. Returns the bits of the processes that may go on because of it.
    /// With `pause`, not beyond the first step behind the next stamp.
    ProcessMask advance(bool pause = false);
    /// Iterations at hand that are ahead of the memory's delays: they find what they take there, however soon they
    /// come, and otherwise only write. 0 where a trail would have to tell of them.
    std::uint64_t fed_iterations() const;
    /// A lookup has worked out the first ones of fed_iterations(), whose accesses fall into these cycles.
    void take_fed(std::vector<Cycles> const& cycles);
    /// Its shape for the iterations that fed_iterations() counts: without what they take from memory.
    std::shared_ptr<ProcessShape> fed_shape() const;
    bool takes_from_memory() const;

    /// Tells which process is at the other end of a port, as a bit for advance().
    void set_neighbour(unsigned port, ProcessMask process_bit);

    /// In the middle of equal iterations, at least this many of which are left.
    bool is_running(std::uint32_t iterations) const {
        if (!in_loop() || by_steps_ || log_.exhausted())
            return false;
        Operation const& operation = log_.front();
        return operation.kind() == Kind::iterate && operation.ports() != 0 && operation.count() >= iterations;
    }

    std::string const& name() const { return name_; }
    unsigned index() const { return index_; }
    Cycles local_time() const { return state_.time; }
    /// No access to come is before this cycle.
    Cycles not_before() const {
        Cycles const cycle = Rules::not_before();
        return cycle <= state_.time ? cycle : 0;  // a loop shorter than its II, entered in cycle 0
    }
    /// Nor does any stamp to come note one before this.
    Cycles stamps_from() const {
        Cycles const cycle = std::min(not_before(), state_.rests ? state_.time - plan_->fill : state_.time);
        return cycle - std::min(cycle, shape_->stamps_back);
    }
    /// The first cycle in which it has nothing to do any more, of what is known.
    Cycles end() const { return flushes() ? state_.flushing.end(state_.time) : state_.time; }
    /// For each token in a flushing pipeline that has no room yet: what has decided so far when it leaves.
    struct Flight {
        Cycles since = 0;
        bool is_room = false;  ///< that another token got; otherwise, that it was taken in
    };
    std::vector<Flight> flights() const;
    /// When a token was due that left a flushing pipeline in a cycle that is not over.
    Cycles due(Cycles left) const;
    /// The port by which the flushing pipeline writes, and whether a token waits there for room.
    unsigned flushing_port() const { return shape_->flushing_port; }
    bool waits_for_room() const { return state_.flushing.is_waiting(); }
    /// Lets tokens out of the flushing pipeline for which there is room now.
    void let_out() { Rules::let_out(); }
    /// The process is stuck: what the iteration that will not begin has waited for writes does not count.
    void take_back_write_waits();
    /// When the process reached the step it is at: its local time, but for the waiting it has been charged with since.
    Cycles waiting_since() const { return state_.time == charged_until_ ? arrival_ : state_.time; }
    std::vector<Cycles> const& stamps() const { return figures_.stamps; }
    std::vector<Cycles> const& next_calls() const { return figures_.next_calls; }
    Cycles empty_stall_cycles() const { return figures_.empty_stall_cycles; }
    Cycles full_stall_cycles() const { return figures_.full_stall_cycles; }
    Cycles memory_stall_cycles() const { return figures_.memory_stall_cycles; }
    LoopCost loop_cost(unsigned loop) const;
    /// What the process waited for its first access of all, if it had nothing to do before it; and at which ports.
    Cycles idle_before_cycles() const { return figures_.idle_before_cycles; }
    Cycles idle_before_cycles(unsigned port) const {
        bool const is_idle = figures_.idle_before_cycles > 0 && port < figures_.waits_before.size();
        return is_idle ? figures_.waits_before[port] : 0;
    }
    /// Of what it waited for at a port, the part that lies beyond a cycle at which the run is over. Of the last few
    /// waits, as hardly more can be: what ends a run has taken what others did for it.
    Cycles waited_beyond(Cycles end, unsigned port) const;
    bool has_accessed() const { return figures_.has_accessed; }

    /// From now on, goes step by step and tells the observer. Null: no longer.
    void set_observer(StepObserver* observer) {
        observer_ = observer;
        by_steps_ = observer != nullptr || !figures_.has_accessed || makes_attempts_;
    }
    /// From now on, tells what decides its times. Null: no longer.
    void set_trail(Trail* trail) { trail_ = trail; }
    Trail* trail() const { return trail_; }
    /// Continues from where another process of the same ports and loops stands, what it has logged included.
    void take_state(ProcessTiming const& other);
    /// The loop that it is in, or was in last.
    unsigned current_loop() const { return state_.loop; }
    /// Done in the loop it is in, or was in last. The lookups keep no more of them than decide anything; who knows
    /// better can say so.
    std::uint64_t iterations() const { return state_.iterations; }
    void set_iterations(std::uint64_t iterations);
    /// Iterations done in all its loops, ever.
    std::uint64_t all_iterations() const;
    std::size_t port_count() const { return ports_.size(); }
    FifoTiming& fifo(unsigned port) const { return *ports_[port].fifo; }
    bool writes(unsigned port) const { return ports_[port].writes; }
    std::shared_ptr<ProcessShape> const& shape() const { return shape_; }
    std::vector<LoopShape> const& loops() const { return shape_->loops; }
    LoopCounters const& loop_counters(unsigned loop) const { return figures_.loops[loop]; }
    /// The port that front() found blocked.
    unsigned blocking_port() const { return blocking_port_; }
    /// Of the ports that front() found blocked the first that is read, or else the first that is written. So it does
    /// not matter who looks, and when.
    unsigned missing_port() const;
    /// The port whose next token the process itself waits for before it can say what it does next; -1: none.
    int starving_port() const { return starving_port_; }
    void set_starving(int port, SourceSite const& site = {}) {
        starving_port_ = port;
        starving_site_ = site;
    }
    /// Of starving_port() and set_starving_with(), the ports of one step, the first without a known token.
    unsigned starved_port() const;
    void set_starving_with(Ports others) { starving_with_ = others; }
    /// Where the process is, for people: "scan, iteration 12".
    std::string position() const;
    /// Where in the source a loop begins, and where a port is accessed outside loops.
    void note_loop_site(unsigned loop, SourceSite const& site) { notes_[loop].sites.note(site); }
    void note_site(unsigned port, SourceSite const& site) { port_sites_[port].note(site); }
    SourceSite loop_site(unsigned loop) const { return notes_[loop].sites.first(); }
    SourceSite port_site(unsigned port) const { return port_sites_[port].first(); }
    /// Of what the process is at, which waits for a port.
    SourceSite site_at_hand(unsigned port) const;
    LoopNotes& notes(unsigned loop) { return notes_[loop]; }
    LoopNotes const& notes(unsigned loop) const { return notes_[loop]; }
    /// Throws InputError if what is read as the first thing is in a later stage than other accesses of the loop.
    void require_first(unsigned loop, unsigned port) const;

    /// Whether an attempt finds room, or a token, now. All that happens before has been told.
    bool found_at(unsigned port) const;
    /// An attempt that was told to find something, or nothing, where it does not.
    struct Deviation {
        unsigned port = 0;
        Cycles cycle = 0;
    };
    /// The first that is known of; `is_over`: all that others do has been told.
    std::optional<Deviation> deviation(bool is_over) const;

    /// For who remembers answers: see lookup_view.hpp.
    class View;

  private:
    friend ProcessRules<ProcessTiming, ProcessPort>;
    friend Rules;
    static constexpr Cycles never = ~Cycles{0};

    unsigned add_port(FifoTiming& fifo, bool writes);
    Rules& rules() { return *this; }
    void go_on_writing();

    // What ProcessRules ask for.
    bool goes_by_steps() const { return by_steps_ || stops_; }
    Cycles first_call() const { return call_delay(); }
    bool may_go_on() {
        bool const goes_on = !pauses_ || figures_.stamps.size() == stamps_before_;
        status_ = Status::ready;
        return goes_on;
    }
    bool may_access(Ports::Number ports);
    void wait_for(ProcessPort const& port);
    void put_in_order(PortSet& set) const;
    /// A wait for memory is the process's own time, in a region of its own. It comes first in a step.
    void note_wait(ProcessPort const& port, Region region, Cycles step, Cycles from, Cycles until) {
        if (!port.fifo->is_stream()) {
            Rules::note_wait(port, region, step, from, until);
            return;
        }
        trail_->marked(index_, Region::memory(), from);
        trail_->marked(index_, region, until);
    }
    void charge(ProcessPort const& port, Cycles stall);
    void performs(Ports::Number ports, Cycles arrival);
    void note(ProcessPort const& port, std::uint64_t count) {
        port.fifo->note(port.writes, count);
        woken_ |= port.neighbour;
        charged_until_ = never;
    }
    void count(std::uint64_t iterations) { figures_.loops[state_.loop].iterations += iterations; }
    void count_end();
    void iterates(std::uint64_t first, std::uint64_t count) {
        if (observer_ != nullptr)
            observer_->iterated(*this, state_.time, first, count, plan_->ii);
    }
    void entered();
    void entered_again();
    void left();
    void awaited_setup(Cycles cycles) { figures_.awaited_setup_cycles += cycles; }
    void awaited_write(Cycles cycles) { figures_.loops[state_.loop].interlock_cycles += cycles; }
    void stamped();
    void let_bubbles_in(ProcessPort const& port, Cycles bubbles, Cycles from);
    void lets_out(ProcessPort const& port, Cycles due, Cycles cycle);
    void waits_for_room(ProcessPort const& /*port*/) const {}
    bool choose(Operation const& operation);
    bool add_ports(Ports::Number ports);
    bool reach_step(Cycles step, bool stops_before);
    void open_window();
    bool end_window();
    bool attempt(Operation const& operation);
    bool reach_attempt(unsigned port, std::uint64_t behind);
    std::optional<Cycles> offset_in_window(unsigned port, std::uint64_t behind) const;
    std::optional<unsigned> attempt_to_come() const;
    Cycles offset_awaited() const;
    void check_failures(Ports::Number ports);
    void deviates(unsigned port, Cycles cycle);
    void add_stall(ProcessPort const& port, Cycles stall);

    std::string name_;
    std::vector<ProcessPort> ports_;
    ProcessFigures figures_;
    bool is_taped_ = false;
    std::vector<OperationLog*> tapes_;
    std::vector<AccessSites> port_sites_;
    std::vector<LoopNotes> notes_;  ///< by loop
    MemoryStream* stream_ = nullptr;
    unsigned stream_port_ = 0;
    StepObserver* observer_ = nullptr;
    bool by_steps_ = true;  ///< until the first access; always when observed, and from the first attempt on
    bool makes_attempts_ = false;
    std::optional<Deviation> deviation_;
    Cycles arrival_ = 0;
    Cycles charged_until_ = never;

    // While it goes on.
    bool stops_ = false;    ///< in front of each step,
    bool granted_ = false;  ///< but for the next one
    bool pauses_ = false;   ///< behind the first stamp
    bool has_more_storage_ = false;
    std::size_t stamps_before_ = 0;
    ProcessMask woken_ = 0;
    // Where it stopped.
    Status status_ = Status::exhausted;
    Ports front_ports_;  ///< accesses of the step at hand
    unsigned blocking_port_ = 0;
    int starving_port_ = -1;
    SourceSite starving_site_;
    Ports starving_with_;
};

}  // namespace dataflow::timing
