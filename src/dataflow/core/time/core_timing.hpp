#pragma once
#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "dataflow/core/memory/memory_stream.hpp"
#include "dataflow/core/time/process_timing.hpp"
#include "dataflow/lookup/automaton.hpp"
#include "dataflow/lookup/steady_state.hpp"

namespace dataflow::timing {

/// One process that cannot go on, and why.
struct Wait {
    std::string process;
    std::string position;
    std::string fifo;
    bool to_write = false;  ///< the FIFO is full; otherwise empty
    std::uint64_t occupancy = 0;
    std::uint64_t capacity = 0;
    Cycles since = 0;   ///< local time of the process
    SourceSite site;    ///< of the loop, or of the access outside loops
    std::string other;  ///< the process at the other end of the FIFO
    bool for_memory = false;
};

/// The FIFOs and processes of one core, and the calculation of their times. Which process goes first never
/// matters: an access gets its cycle once everything that decides it is known.
class CoreTiming {
  public:
    static constexpr std::size_t most_processes = 64;  ///< a bit each

    FifoTiming& add_fifo(FifoShape shape);
    /// The shape may be that of another process of the same ports.
    ProcessTiming& add_process(std::string name,
                               std::shared_ptr<ProcessShape> shape = std::make_shared<ProcessShape>());
    /// A process's end of the external memory.
    MemoryStream& add_stream(std::string const& name, MemoryStream::EntersBy enters_by) {
        return streams_.emplace_back(name, enters_by);
    }
    MemoryStream& stream(std::size_t number) { return streams_[number]; }
    std::deque<MemoryStream> const& streams() const { return streams_; }
    /// From when on processes may do something that is not logged yet, once all that is has its cycles, or waits.
    Cycles unknown_from() const;

    /// Gives cycles to all logged operations that can have them. With `to_the_end` false, may leave some for later
    /// whose answer by other processes is not logged yet: it will be quicker then. Counters are complete only at the
    /// end.
    void resolve(bool to_the_end = true);

    /// Gives cycles to what can have them once some processes, a bit each, have got tokens from memory; with or without
    /// an automaton.
    void resume(ProcessMask processes);

    /// Gives cycles to what can have them where only some processes, a bit each, have more to do than before; without
    /// automaton.
    void resolve_processes(ProcessMask processes);

    /// Gives cycles to all that a script says, which goes on where the logs end: what cannot be done yet is in the logs
    /// then. There must be an automaton. In parts, so that cores that share an automaton can take turns:
    ///
    ///     core.take_up(script);
    ///     while (core.set_out()) {
    ///         automaton.go_on({&core.walk()});
    ///         core.arrive();
    ///     }
    void take_up(Script& script);
    /// Otherwise all of a script goes to the logs.
    bool follows_script() const { return follows_; }
    /// As far as a walk; false: the script is done, or, behind a memory, the driver waits: it goes on from there once
    /// the memory has brought more.
    bool set_out();
    Automaton::Walk& walk() { return walk_; }
    void arrive();
    /// The walk between set_out() and arrive(), for a core that does not take turns.
    void let_walk();
    /// The whole script from take_up() on, for a core that does not take turns.
    void walk_through();

    /// A core that stands where this one does and goes on by itself, from the operations logged so far; without
    /// automaton.
    std::unique_ptr<CoreTiming> copy();
    /// A core of the same FIFOs and processes, in which nothing has happened yet.
    std::unique_ptr<CoreTiming> blank_copy() const;
    /// Lets an automaton, which may be shared with cores of the same shape, follow the group of a lead. A lead without
    /// followers has nothing to follow: the core stays as it is.
    void let_follow(Lead const& lead, std::shared_ptr<Automaton> automaton);

    /// Takes down what decides the times from now on. Before anything has happened.
    void leave_trail(std::size_t length = Trail::usual_length);
    Trail const* trail() const { return trail_.get(); }
    /// All of it, which forgets it; in cycles since `origin`.
    std::vector<TrailEvent> take_trail(Cycles origin) { return trail_->take(origin); }
    /// Keeps the trail short. Now and then, between operations.
    void shorten_trail();
    Automaton const* automaton() const { return automaton_.get(); }

    FifoTiming& fifo(std::size_t number) { return fifos_[number]; }
    ProcessTiming& process(std::size_t number) { return processes_[number]; }
    std::deque<FifoTiming> const& fifos() const { return fifos_; }
    std::deque<ProcessTiming> const& processes() const { return processes_; }
    std::size_t number_of(FifoTiming const& fifo) const;
    std::size_t number_of(MemoryStream const& stream) const;
    /// Numbers of the processes at a FIFO; -1: none. Once connected, by the first resolve().
    struct Ends {
        int writer = -1;
        int reader = -1;
    };
    Ends const& ends(unsigned process, unsigned port) const { return ends_[number_of(processes_[process].fifo(port))]; }

    /// The processes with operations left, in order; call after resolve(). Empty unless the core is stuck.
    std::vector<Wait> waits();

  private:
    void connect();
    void go_on(bool to_the_end);
    std::string name_at_other_end(ProcessTiming const& process, unsigned port) const;
    void find_patient();
    /// All but the processes `held`, a bit each.
    void settle(ProcessMask runnable, ProcessMask held);
    bool keep_more();
    bool group_has_started(ProcessMask all);
    bool let_driver_go();
    bool awaits_memory() const;
    ProcessMask all_processes() const {
        return processes_.empty() ? 0 : ~ProcessMask{0} >> (most_processes - processes_.size());
    }
    void write_next();

    std::deque<FifoTiming> fifos_;  // deque: references stay valid
    std::deque<MemoryStream> streams_;
    std::deque<ProcessTiming> processes_;
    std::vector<Ends> ends_;            // by FIFO
    std::vector<ProcessMask> patient_;  // by process: those that need not go on at once when it has
    SteadyState steady_state_;
    std::unique_ptr<Trail> trail_;
    std::shared_ptr<Automaton> automaton_;
    std::unique_ptr<Group> group_;
    Automaton::Session session_;
    Automaton::Walk walk_;
    bool follows_ = false;  ///< the script at hand
    Lead lead_;
    bool started_ = false;
};

}  // namespace dataflow::timing
