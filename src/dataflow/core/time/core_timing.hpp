#pragma once
#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "dataflow/core/memory/memory_stream.hpp"
#include "dataflow/core/time/process_timing.hpp"
#include "dataflow/core/time/trail.hpp"

namespace dataflow::timing {

/// One process that cannot go on, and why.
struct BlockedProcess {
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
/// matters: an access gets its cycle once everything that decides it is known. Who remembers answers derives from this,
/// and gives cycles by what it remembers: the same ones.
class CoreTiming {
  public:
    CoreTiming() = default;
    virtual ~CoreTiming() = default;
    CoreTiming(CoreTiming const&) = delete;
    CoreTiming& operator=(CoreTiming const&) = delete;

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

    /// Gives cycles where some processes, a bit each, have got tokens from memory.
    virtual void resume(ProcessMask processes) { resolve_processes(processes); }

    /// Works out what can be where only some processes, a bit each, have more to do than before.
    void resolve_processes(ProcessMask processes);

    /// Somebody goes step by step through what processes are told, copies the core, or follows its trail: nobody may
    /// put that into another form. Before anything has happened.
    void keep_logs() { keeps_logs_ = true; }
    bool keeps_logs() const { return keeps_logs_ || trail_ != nullptr; }

    /// A core that stands where this one does and goes on by itself, from the operations logged so far. It
    /// remembers nothing.
    std::unique_ptr<CoreTiming> copy();
    /// A core of the same FIFOs and processes, in which nothing has happened yet.
    std::unique_ptr<CoreTiming> blank_copy() const;
    /// Makes that of a core without FIFOs and processes.
    void be_blank_copy_of(CoreTiming const& core);
    /// Makes a trail shorter that has become long, so that it tells the same to whoever follows it.
    using ShortenTrail = void (*)(CoreTiming const&, Trail&);
    /// Takes down what decides the times from now on. Before anything has happened.
    void leave_trail(ShortenTrail shorten, std::size_t length = Trail::usual_length);
    Trail const* trail() const { return trail_.get(); }
    /// All of it, which forgets it; in cycles since `origin`.
    std::vector<TrailEvent> take_trail(Cycles origin) { return trail_->take(origin); }
    /// Keeps the trail short. Now and then, between operations.
    void shorten_trail();

    FifoTiming& fifo(std::size_t number) { return fifos_[number]; }
    ProcessTiming& process(std::size_t number) { return processes_[number]; }
    std::deque<FifoTiming> const& fifos() const { return fifos_; }
    std::deque<ProcessTiming> const& processes() const { return processes_; }
    std::size_t number_of(FifoTiming const& fifo) const;
    std::size_t number_of(MemoryStream const& stream) const;
    /// Number of the process at the other end of a process's FIFO; -1: none. Once connected, by the first resolve().
    int other_end(ProcessTiming const& process, unsigned port) const {
        Ends const& ends = ends_[number_of(process.fifo(port))];
        return process.writes(port) ? ends.reader : ends.writer;
    }

    /// The processes with operations left, in order; call after resolve(), at the end: what their next iterations have
    /// waited for writes is taken back. Empty unless the core is stuck.
    std::vector<BlockedProcess> blocked();

  protected:
    // What a core that remembers answers does in its own way.

    /// Gives cycles to what is logged, as resolve() says.
    virtual void go_on(bool to_the_end);
    /// Before a process goes on that has many equal iterations to do, ProcessTiming::long_count at least: may do the
    /// most of them at once, and others' that only feed each other with it. Who else may go on because of it.
    virtual ProcessMask run_ahead(ProcessTiming& /*process*/) { return 0; }
    /// Enters in the counters of processes and FIFOs what is kept elsewhere.
    virtual void complete_counters() {}
    /// Before processes go on, which may have been told more.
    virtual void look_at_logs() {}
    /// Everybody's FIFOs are known now.
    virtual void note_connected() {}
    virtual void note_trail(Trail& /*trail*/) {}

    /// Before anything is worked out.
    void connect();
    /// All that can be done by `runnable`, and by those that may go on because of it, but for `held`; a bit each.
    void settle(ProcessMask runnable, ProcessMask held);
    ProcessMask all_processes() const {
        return processes_.empty() ? 0 : ~ProcessMask{0} >> (most_processes - processes_.size());
    }
    std::deque<ProcessTiming>& own_processes() { return processes_; }
    /// Of unlimited FIFOs whose writers have got ahead as far as cycles are kept; false: of none.
    bool keep_more();

  private:
    std::string name_at_other_end(ProcessTiming const& process, unsigned port) const;
    void find_patient();

    std::deque<FifoTiming> fifos_;  // deque: references stay valid
    std::deque<MemoryStream> streams_;
    std::deque<ProcessTiming> processes_;
    struct Ends {
        int writer = -1;
        int reader = -1;
    };
    std::vector<Ends> ends_;            // by FIFO
    std::vector<ProcessMask> patient_;  // by process: those that need not go on at once when it has
    bool keeps_logs_ = false;
    std::unique_ptr<Trail> trail_;
    ShortenTrail shorten_trail_ = nullptr;
};

}  // namespace dataflow::timing
