#pragma once
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <systemc>
#include <utility>
#include <vector>

#include "channels/clocked_fifo.hpp"
#include "channels/ping_pong.hpp"
#include "channels/time_base.hpp"
#include "dataflow/base/core_share.hpp"
#include "dataflow/base/worker.hpp"
#include "dataflow/base/write_distances.hpp"
#include "dataflow/core/machine/machine.hpp"
#include "dataflow/phrases/phrase_core.hpp"
#include "dataflow/run/config/calls.hpp"
#include "dataflow/run/figures/run_statistics.hpp"
#include "dataflow/tools/recording/running_core.hpp"

namespace dataflow {

/// One core of a machine: the SystemC module that a design derives its own from. The derived class has the modules and
/// the FIFOs between them as members, and binds them:
///
///     ClockedFifo<Pixel> pixels_{"pixels", fifo_timing("pixels")};
///     Reader reader_{"reader", *this};
///
/// Everything else is known from the machine: all its FIFOs and processes have their places in the core's timing from
/// the start, and every FIFO that is a member, or a module's member, is found by itself.
///
/// Its processes say where a sample begins (begin_sample) and the last one where it is done (end_sample); those are
/// told to whoever has asked for it.
class DataflowCore : public sc_core::sc_module, public recording::RunningCore {
  public:
    DataflowCore(sc_core::sc_module_name const& name, std::shared_ptr<Machine const> machine, CoreShare share,
                 TimeBase const& time_base);

    Machine const& machine() const override { return *machine_; }
    /// The samples that this core does.
    CoreShare share() const override { return share_; }
    TimeBase const& time_base() const { return time_base_; }
    timing::PhraseCore& timing() override { return *timing_; }
    timing::PhraseCore const& timing() const { return *timing_; }

    /// By number of the FIFO in the machine; null where the core has no such channel. Once the core is constructed.
    std::vector<FifoChannel*> const& channels() const;
    /// A FIFO by its name in the machine: how its two modules get at it where they have no ports for it. Once the core
    /// is constructed. Errors: std::out_of_range if there is none; std::logic_error if it carries other tokens.
    template <class Token> ClockedFifo<Token>& fifo(std::string_view name) const {
        auto* const found = dynamic_cast<ClockedFifo<Token>*>(channels()[machine_->fifo(name)]);
        if (found == nullptr)
            throw std::logic_error("the FIFO " + std::string(name) + " is not there, or carries other tokens");
        return *found;
    }
    /// Ping-pong buffers by their name, likewise.
    template <class Word> PingPong<Word>& ping_pong(std::string const& name) const {
        auto* const found = dynamic_cast<PingPong<Word>*>(channels()[machine_->fifo(filled_fifo(name))]);
        if (found == nullptr)
            throw std::logic_error("the ping-pong buffer " + name + " is not there, or has other words");
        return *found;
    }
    /// The external memory that the cores share, and the number of this one; null: an ideal one.
    void use_memory(timing::MemorySystem* memory, std::size_t number, sc_core::sc_event* asked) {
        memory_ = memory;
        number_ = number;
        memory_asked_ = asked;
    }
    /// To be called with all that is told of a master, by its number.
    using EntryCall = std::function<void(std::size_t master, timing::MemoryEntry const& entry)>;
    void on_entry(EntryCall call) { entry_call_ = std::move(call); }
    /// More for a process's stream, which it has, before it comes there.
    void add_entry(std::size_t process, timing::MemoryEntry entry);
    /// A process has come to an entry, or taken tokens (lockstep).
    void tell_memory() { memory_asked_->notify(sc_core::SC_ZERO_TIME); }
    /// Memory has something for a process.
    sc_core::sc_event& memory_event(std::size_t process) { return memory_events_[process]; }

    std::vector<TokenField> token_fields(std::size_t fifo) const override;
    void add_tap(std::size_t fifo, recording::TokenTap& tap) override;
    void remove_tap(std::size_t fifo, recording::TokenTap& tap) override;

    /// Results of the samples done so far: how many there are, and the i-th of this core. A design that has any
    /// overrides both.
    virtual std::size_t results() const { return samples_ended_; }
    virtual Counters result(std::size_t /*i*/) const { return {}; }

    /// From now on, loops whose addresses their modules tell are looked after. Before the core is elaborated.
    void watch_dependences() { watches_dependences_ = true; }
    /// Where a loop tells which words of a memory it accesses; null if nobody wants to know, or if it does not write
    /// the memory. Somebody does if dependences are watched, or if iterations of the loop wait for each other's writes.
    WriteDistances* write_distances(std::size_t process, std::string_view loop, std::string_view memory);
    std::vector<DependenceStatistics> dependences() const;

    /// Its modules begin no further sample.
    void leave() { is_left_ = true; }
    bool is_left() const { return is_left_; }

    /// Calls back after every sample.
    void set_progress(std::function<void()> progress) { progress_ = std::move(progress); }
    /// Calls back when the core is wired up and nothing has happened yet.
    void on_start(std::function<void()> call) { starts_.push_back(std::move(call)); }
    /// Calls back before the machine's process that begins samples begins the i-th sample of the core.
    void on_sample_begins(std::function<void(std::size_t i)> call) { sample_begins_.push_back(std::move(call)); }
    /// Calls back whenever a process begins its next sample, with the number of the process.
    void on_process_begins(std::function<void(std::size_t process)> call) {
        process_begins_.push_back(std::move(call));
    }

    /// Lets this core begin when another one, if there is one, has done its share. Cores need not take turns, as they
    /// share nothing; but one after the other keeps the host's caches warm (decoupled).
    void run_after(DataflowCore const* other) { before_ = other; }
    /// Whether the core has done its share, or has let the next one begin all the same.
    bool is_turn_over() const { return is_turn_over_; }
    /// A process cannot go on.
    void fail(std::size_t process, std::exception_ptr error) { errors_.emplace(process, std::move(error)); }
    bool has_failed() const { return !errors_.empty(); }
    /// When all that is known has its cycles: throws the error of the first process in the machine's order that has
    /// failed, whichever the engine came to first. Not of one that is stuck before it comes there: in decoupled, a
    /// module is ahead of time.
    void throw_error() const;
    /// Lets the next core begin. By itself when the share is done.
    void end_turn();
    /// Gives all operations logged so far their cycles, where the SystemC kernel does not do so (decoupled); or tells
    /// the thread that does.
    void catch_up() override;
    /// From the start of simulation on, a thread gives operations their cycles (decoupled): until that has finished,
    /// the timing is the thread's alone. Processes log what they do in log_for_thread() then, instead of in their
    /// timing.
    void use_thread(Worker& thread);
    /// Of a process; null: nobody takes them, they belong into its timing.
    timing::OperationLog* log_for_thread(std::size_t process) {
        return thread_ == nullptr ? nullptr : &logs_for_thread_[process];
    }

    /// A module has made its clock of that process. Each that the machine has needs one before the simulation starts.
    void add_process(std::size_t process) { has_process_[process] = true; }
    /// Of the calling thread, which most probably is that of `likely`; none: it is no process of the core.
    std::optional<std::size_t> running_process(std::size_t likely) const;
    /// Every process calls this before the first operation of each of its samples. A process that reads no FIFO waits
    /// here for the core's turn before its first sample.
    void begin_sample(std::size_t process);
    /// So many samples a process has begun.
    std::size_t begun(std::size_t process) const { return begun_[process]; }
    /// The process that ends samples calls this when it has done all of one.
    void end_sample();

  protected:
    /// Of a FIFO by its name in the machine, to make its channel with.
    timing::FifoTiming& fifo_timing(std::string_view fifo) { return timing_->fifo(machine_->fifo(fifo)); }

    /// Of ping-pong buffers by their name.
    timing::FifoTiming& ping_pong_timing(std::string const& name) { return fifo_timing(filled_fifo(name)); }

    /// A FIFO that needs no member: its modules ask for it by fifo(), or have ports that are bound to it. In the
    /// constructor only.
    template <class Token> ClockedFifo<Token>& make_fifo(std::string const& name) {
        auto fifo = std::make_unique<ClockedFifo<Token>>(name.c_str(), fifo_timing(name));
        ClockedFifo<Token>& made = *fifo;
        made_.push_back(std::move(fifo));
        return made;
    }
    /// A module that needs no member. In the constructor only.
    template <class Module, class... Arguments> Module& make_module(char const* name, Arguments&&... arguments) {
        auto module = std::make_unique<Module>(name, std::forward<Arguments>(arguments)...);
        Module& made = *module;
        made_modules_.push_back(std::move(module));
        return made;
    }

  private:
    void start_of_simulation() override;
    void tell_thread();
    void require_interlocks() const;
    void require_modules() const;
    void find_channels(sc_core::sc_object const& parent) const;
    void await_turn_of(std::size_t process) const;

    std::shared_ptr<Machine const> machine_;
    CoreShare share_;
    TimeBase time_base_;
    std::unique_ptr<timing::PhraseCore> timing_ = timing::make_core();
    Worker* thread_ = nullptr;
    std::vector<timing::OperationLog> logs_for_thread_;  // by process
    timing::MemorySystem* memory_ = nullptr;
    EntryCall entry_call_;
    std::size_t number_ = 0;
    sc_core::sc_event* memory_asked_ = nullptr;
    std::deque<sc_core::sc_event> memory_events_;  // by process
    std::vector<std::unique_ptr<FifoChannel>> made_;
    std::vector<std::unique_ptr<sc_core::sc_module>> made_modules_;
    struct WatchedDependence {
        std::size_t loop;    // number in the machine
        std::size_t number;  // of the dependence in the loop
        std::unique_ptr<WriteDistances> distances;
    };
    bool watches_dependences_ = false;
    std::vector<WatchedDependence> watched_;
    mutable std::vector<FifoChannel*> channels_;  // empty until somebody asks for them
    std::function<void()> progress_;
    std::vector<std::function<void()>> starts_;
    std::vector<std::function<void(std::size_t)>> sample_begins_;
    std::vector<std::function<void(std::size_t)>> process_begins_;
    std::vector<std::size_t> begun_;  // samples, by process
    std::size_t samples_ended_ = 0;
    std::map<std::size_t, std::exception_ptr> errors_;   // by process
    std::vector<bool> has_process_;                      // a module has made its clock
    std::vector<sc_core::sc_process_b const*> threads_;  // by process, once it has begun a sample
    DataflowCore const* before_ = nullptr;               // whose turn is before
    bool is_turn_over_;
    bool is_left_ = false;
    sc_core::sc_event turn_ends_{"turn_ends"};
};

}  // namespace dataflow
