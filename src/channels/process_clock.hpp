#pragma once
#include <algorithm>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <systemc>
#include <utility>
#include <vector>

#include "channels/time_base.hpp"
#include "dataflow/base/cycles.hpp"
#include "dataflow/base/source_site.hpp"
#include "dataflow/base/write_distances.hpp"
#include "dataflow/core/machine/module_description.hpp"
#include "dataflow/core/memory/memory_block.hpp"
#include "dataflow/core/time/core_timing.hpp"

namespace dataflow {

class DataflowCore;
struct MachineStream;
class FifoChannel;

/// The local time of one process, in cycles; the only way a module lets time pass (docs/timing-model.md#vocabulary).
/// The module says what it does - advance, step, pipelined loop -, the clock decides when. In `lockstep` it does so at
/// once and takes the SystemC kernel along before every access; in `decoupled` it notes the operations and lets the
/// core's timing catch up later. The cycles are the same: both run through timing::ProcessTiming.
class ProcessClock {
  public:
    /// Of a core's process, by its name in the machine. Errors: InputError if the core has none of that name.
    ProcessClock(DataflowCore& core, std::string_view process);

    /// Takes the process's ends of all FIFOs that the machine says it has. Once, at the end of elaboration: the core's
    /// channels must be there. Errors: InputError if a FIFO of the process has no channel.
    void connect_all();
    /// The number of a loop for enter_loop(), by its name in the process. After connect_all().
    /// Errors: InputError if the process has no such loop.
    unsigned loop(std::string_view name) const;

    /// What the configuration says of a number of the module, by its name: ModuleDescription::number().
    /// Errors: InputError if the module has no such number.
    std::uint64_t number(std::string_view name) const;

    /// Where a loop of the process tells which words of a memory its iterations access, by their names. Null if nobody
    /// wants to know, as mostly. Once, after connect_all(): in start_of_simulation() of the module. Each iteration of
    /// that loop calls next_iteration() there and says its words, before any other of the process begins. The clock
    /// calls enter() there.
    WriteDistances* write_distances(std::string_view loop, std::string_view memory);
    /// Whether iterations of a loop may have to wait for writes (`hazards: interlock`). They are told one by one then.
    bool has_interlocks(unsigned loop) const;
    /// Whether iterations of a loop read all that they do before they do anything else, and make no attempts: then the
    /// module may do many at once. They read in stage 0: in lockstep, time passes before a later one.
    bool reads_first(unsigned loop) const;
    /// The module reads these before anything else that an iteration does: a recording of it keeps that.
    void note_first_reads(unsigned loop, timing::Ports ports) {
        timing_.notes(loop).first = timing_.notes(loop).first | ports;
    }
    /// Errors: InputError if an iteration that accesses `others` may not access `port` as well: it is one of them, or
    /// the loop does not name it.
    void require_access(unsigned loop, timing::Ports others, timing::Ports port) const;
    /// The next iteration to be told waits for the writes of others that it must not overtake: those that its loop's
    /// WriteDistances have met in the iteration at hand there, or in the one before it. pipeline() and TokenLoop say so
    /// for theirs.
    void await_writes(unsigned loop, bool of_one_before = false);

    /// The call of all modules that it is part of begins, then its own, and that ends: SampleModule says so.
    void begin_region() { hand_over(FifoEnd::When::region_begins); }
    void begin_call();
    void end_call();
    /// No call follows.
    void end_calls();

    /// The process is about to begin its next sample, or has done all of one: see DataflowCore.
    void begin_sample();
    void end_sample();

    /// T += cycles.
    void advance(Cycles cycles) {
        require_outside("lets time pass");
        if (cycles > longest_wait)
            refuse_wait(cycles);
        say([cycles](OperationLog& log) {
            Cycles left = cycles;
            for (; left > longest_count; left -= longest_count)
                log.wait(longest_count);
            log.wait(static_cast<std::uint32_t>(left));
        });
    }
    /// T += the cycles of a setup.
    void set_up() {
        require_outside("prepares something");
        say([](OperationLog& log) { log.setup(); });
    }
    /// Between iterations of a loop: a setup begins; the loop waits until the oldest one not awaited yet is done.
    void begin_setup() {
        require_loop("begins a setup");
        say([](OperationLog& log) { log.begin_setup(); });
    }
    void await_setup() {
        require_loop("awaits a setup");
        say([](OperationLog& log) { log.await_setup(); });
    }
    /// Where the next access outside loops stands in the source. Deadlock reports name it, or the begin of a loop.
    void here(SourceSite site = SourceSite::here()) { site_ = site; }
    /// The accesses of one step, together.
    void step(timing::Ports ports) {
        say([ports](OperationLog& log) { log.step(ports.number(), 0); });
    }
    /// Notes the local time, or the cycle before it: see ModuleDescription::stamps_look_back. Read back from
    /// timing().stamps().
    void stamp() {
        require_outside("notes its time");
        say([](OperationLog& log) { log.stamp(); });
        core_.shorten_trail();
    }

    void enter_loop(unsigned loop, SourceSite site = SourceSite::here()) {
        if (collecting_ || is_in_loop_)
            refuse_inside("begins a loop");
        if (loop >= timing_.loops().size())
            refuse_number(loop);
        is_in_loop_ = true;
        if (stream_ != nullptr)
            enter_memory(loop);
        timing_.note_loop_site(loop, site);
        say([loop](OperationLog& log) { log.enter(loop); });
    }
    /// `count` times: an iteration that accesses `ports`, then `gap` iterations that access nothing. Inlined by force:
    /// the scan says little else.
    [[gnu::always_inline]] void iterate(timing::Ports ports, std::uint64_t count, std::uint16_t gap = 0) {
        require_loop("does an iteration");
        say([=](OperationLog& log) {
            std::uint64_t left = count;
            for (; left > longest_count; left -= longest_count)
                log.iterate(ports.number(), gap, longest_count);
            log.iterate(ports.number(), gap, static_cast<std::uint32_t>(left));
        });
    }
    /// `count` iterations that access `ports`, one that accesses `tail_ports`, and `tail_gap` that access nothing.
    void iterate_with_tail(timing::Ports ports, std::uint32_t count, timing::Ports tail_ports, std::uint32_t tail_gap) {
        require_loop("does an iteration");
        say([=](OperationLog& log) { log.iterate_with_tail(ports.number(), count, tail_ports.number(), tail_gap); });
    }
    /// An iteration that accesses `ports`, one that accesses `tail_ports`, then iterate_with_tail() for the other
    /// `count` - 1, which is not 0.
    void iterate_flanked(timing::Ports ports, std::uint32_t count, timing::Ports tail_ports, std::uint32_t tail_gap) {
        require_loop("does an iteration");
        say([=](OperationLog& log) { log.iterate_flanked(ports.number(), count, tail_ports.number(), tail_gap); });
    }
    /// `length` iterations that access `ports`, the i-th followed by a silent one if bit i of `gaps` is set; at
    /// most 32.
    void iterate_mixed(timing::Ports ports, unsigned length, std::uint32_t gaps) {
        require_loop("does an iteration");
        say([=](OperationLog& log) { log.iterate_mixed(ports.number(), length, gaps); });
    }
    void leave_loop() {
        require_loop("leaves a loop");
        is_in_loop_ = false;
        say([](OperationLog& log) { log.leave(); });
    }
    /// All of a pipelined loop: `count` iterations of `body`, which is called with their numbers from 0 on. What it
    /// reads and writes through plain ports are the accesses of the iteration; time passes between iterations only.
    /// What it reads through plain ports is read in the first stage of the loop that accesses anything; any other
    /// read is for take_later(). Without an iteration, the loop is not entered. Errors: InputError for a plain read of
    /// a FIFO that the loop reads in a later stage.
    template <class Body>
    void pipeline(std::string_view loop_name, std::uint64_t count, Body body, SourceSite site = SourceSite::here()) {
        unsigned const number = loop_to_run(loop_name);
        if (is_left_out(number, count))
            return;
        open_loop(number, site);
        for (std::uint64_t i = 0; i < count; ++i) {
            open_iteration(i);
            body(i);
            close_iteration();
        }
        close_loop();
    }
    /// `count` iterations that access nothing.
    void pipeline(std::string_view loop_name, std::uint64_t count, SourceSite site = SourceSite::here()) {
        unsigned const number = loop_to_run(loop_name);
        if (is_left_out(number, count))
            return;
        enter_loop(number, site);
        iterate(timing::no_ports, count);
        leave_loop();
    }
    /// `count` iterations, each of which accesses the same FIFOs: `tokens` is tokens_of(ports...), and `body` is called
    /// with the tokens read, then with those to be written, and before them with the iteration's number, if it takes
    /// one. It accesses nothing itself. The fast form, and no longer than the others.
    template <class Tokens, class Body>
    void pipeline(std::string_view loop_name, std::uint64_t count, Tokens const& tokens, Body body,
                  SourceSite site = SourceSite::here()) {
        unsigned const number = loop_to_run(loop_name);
        if (is_left_out(number, count))
            return;
        if (reads_first(number))
            in_tokens_body([&] { tokens.loop(*this, loop_name).run_each(count, body, site); });
        else
            pipeline(loop_name, count, tokens.by_plain_accesses(*this, body), site);
    }
    /// Of a loop whose trip count depends on what it does: as many iterations as `body` asks for, by returning true.
    template <class Body>
    void pipeline_while(std::string_view loop_name, Body body, SourceSite site = SourceSite::here()) {
        open_loop(loop_to_run(loop_name), site);
        decides_trip_count_ = true;
        bool goes_on = true;
        for (std::uint64_t i = 0; goes_on; ++i) {
            open_iteration(i);
            goes_on = body(i);
            close_iteration();
        }
        close_loop();
    }
    template <class Tokens, class Body>
    void pipeline_while(std::string_view loop_name, Tokens const& tokens, Body body,
                        SourceSite site = SourceSite::here()) {
        if (reads_first(loop_to_run(loop_name)))
            in_tokens_body([&] { tokens.loop(*this, loop_name).run_while(body, site); });
        else
            pipeline_while(loop_name, tokens.by_plain_accesses(*this, body), site);
    }
    /// Calls what calls bodies that access nothing themselves.
    template <class Call> void in_tokens_body(Call call) {
        is_in_tokens_body_ = true;
        call();
        is_in_tokens_body_ = false;
    }
    /// A loop in pieces, for who has no body that can be called. Iterations are numbered from 0 on.
    void open_loop(unsigned loop, SourceSite site = SourceSite::here());
    void open_iteration(std::uint64_t iteration) {
        if (!is_plain_)
            reach(iteration);
        begin_collecting();
        open_ = sound_.accesses;
    }
    void close_iteration() {
        collecting_ = false;
        open_ = 0;
        if (!is_plain_ || !log_->repeat(collected_.number()))
            end_body();
        else
            collected_ = timing::no_ports;
    }
    void close_loop();
    /// In the body of an iteration, which reads a FIFO in a later stage (FifoEnd::taken): when the iteration has got to
    /// that stage, `use` is called with the token. That is before the body of any iteration that begins after that, and
    /// after those of all that begin before. Tokens that `use` makes of it are put into their FIFOs by put(), and the
    /// body says by access(fifo.write_port()) that its iteration writes them.
    template <class Fifo, class Use> void take_later(Fifo& fifo, Use use) {
        access(read_port_of(fifo));
        later(fifo, [&fifo, use = std::move(use)]() mutable { use(fifo.take()); });
    }
    /// All of a loop that is not pipelined (LoopDescription::of_states), likewise.
    template <class Body>
    void repeat(std::string_view loop_name, std::uint64_t count, Body body, SourceSite site = SourceSite::here()) {
        pipeline(loop_name, count, std::move(body), site);
    }
    template <class Tokens, class Body>
    void repeat(std::string_view loop_name, std::uint64_t count, Tokens const& tokens, Body body,
                SourceSite site = SourceSite::here()) {
        pipeline(loop_name, count, tokens, std::move(body), site);
    }
    /// All of a pipelined loop whose every iteration reads `late_fifo` in a later stage: `take` is called with the
    /// number of the iteration that has got there, and takes the token itself.
    template <class Body, class Take>
    void pipeline(std::string_view loop_name, std::uint64_t count, Body body, FifoChannel& late_fifo, Take take,
                  SourceSite site = SourceSite::here()) {
        auto const whole_body = [&](std::uint64_t i) {
            access(read_port_of(late_fifo));
            later(late_fifo, [&take, i] { take(i); });
            body(i);
        };
        pipeline(loop_name, count, whole_body, site);
    }

    // Non-blocking accesses (ClockedFifo): in the body of pipeline(), if their step is before the next iteration's
    // first access; outside loops, at the local time. Any other of an iteration is made by try_read_later() and
    // try_write_later(): when the iteration has got to the stage, `use` is called with the token, or null, or with
    // whether the token was written.

    template <class Fifo, class Use> void try_read_later(Fifo& fifo, Use use) {
        attempt_later(fifo, read_port_of(fifo), [this, &fifo, use = std::move(use)](std::uint64_t step) mutable {
            if (!attempts_in(read_port_of(fifo), step)) {
                use(nullptr);
                return;
            }
            auto const token = fifo.take();
            use(&token);
        });
    }
    template <class Fifo, class Token, class Use> void try_write_later(Fifo& fifo, Token token, Use use) {
        attempt_later(fifo, write_port_of(fifo),
                      [this, &fifo, token = std::move(token), use = std::move(use)](std::uint64_t step) mutable {
                          bool const is_written = attempts_in(write_port_of(fifo), step);
                          if (is_written)
                              fifo.put(token);
                          use(is_written);
                      });
    }
    /// Whether an access finds a token, or room, in the cycle of its step. Then it takes place.
    bool attempts(FifoChannel const& fifo, timing::Ports port) { return attempts(fifo, port, false); }
    /// Whether one would; no access takes place.
    bool asks(FifoChannel const& fifo, timing::Ports port) { return attempts(fifo, port, true); }

    bool uses_memory() const { return timing_.stream() != nullptr; }
    /// The process's port to the external memory, for an iteration that takes a token, or none if the memory is ideal.
    timing::Ports memory_port() const;
    /// Takes a token from the memory, or gives it one, as an access of a step or of the iteration at hand; nothing if
    /// the memory is ideal. Errors: InputError where the description says something else or has no port to the memory,
    /// and for a second one.
    void access_memory();
    /// What the process takes from memory, or puts there, in its next loop or step that it has not told of yet. Any
    /// time before. It must use memory.
    void tell_entry(timing::MemoryEntry entry);
    /// Tokens of so many bytes, one behind the other from an address on, of the sample that has begun: what the next
    /// loop or steps take from memory by access_memory(), or give it; of a loop, the ranges of all calls before it is
    /// entered. Nothing if the memory is ideal. A SampleModule takes, or gives, what it has told of, all of it. Errors:
    /// InputError as access_memory().
    struct Range {
        std::uint64_t address = 0;
        std::uint64_t tokens = 1;
        std::uint64_t token_bytes = 1;
    };
    void tell_ranges(std::vector<Range> const& ranges);

    /// The access of one port by plain sc_fifo_if calls: a step of its own, or part of the Step that is open.
    /// Errors: InputError for one that is accessed twice in a step or iteration, or that its loop does not name.
    void access(timing::Ports port) {
        if (!accesses_soundly(port))
            access_closely(port);
    }
    /// access(), where that needs no closer look: most of what happens. False: it does.
    bool accesses_soundly(timing::Ports port) {
        if ((open_ & port.number()) == 0)
            return false;
        open_ &= ~std::uint32_t{port.number()};
        collected_ = timing::Ports(static_cast<timing::Ports::Number>(collected_.number() | port.number()));  // masks
        return true;
    }
    /// begins_read() and access(), likewise.
    bool reads_soundly(timing::Ports port) {
        if ((sound_.first_reads & port.number()) == 0 || !accesses_soundly(port))
            return false;
        taken_ = timing::Ports(static_cast<timing::Ports::Number>(taken_.number() | port.number()));
        return true;
    }

    /// Errors: InputError if the calling thread is that of another module of the core: it has no such end of the FIFO.
    void require_own(FifoChannel const& fifo, bool writes) const {
        if (is_away_)
            require_calling(fifo, writes);
    }
    /// Errors: InputError if a FIFO's port that reads or writes is not the process's.
    void require_end(FifoChannel const& fifo, timing::Ports port, bool writes) const;

    bool lockstep() const { return time_base_.engine == Engine::lockstep; }
    timing::ProcessTiming const& timing() const { return timing_; }
    Cycles local_time() const { return timing_.local_time(); }

    /// The calling thread is about to read a token of the FIFO. Errors: see pipeline().
    void begins_read(timing::Ports port) {
        if (is_in_tokens_body_)
            access_closely(port);  // which refuses it
        if (!collecting_)
            return;
        if (is_pipelining_)
            require_first_stage(port);
        taken_ = taken_ | port;
    }
    /// Suspends the calling thread until the FIFO's other side may have done something; what for is told to deadlock
    /// reports, and `others` that have a token and are read in the same cycle.
    void wait_for_tokens(FifoChannel& fifo, timing::Ports others = {});
    void wait_for_room(FifoChannel& fifo);

  private:
    friend class Step;
    static constexpr std::uint32_t longest_count = timing::Operation::longest_count;

    using OperationLog = timing::OperationLog;

    template <class Entry> [[gnu::always_inline]] void say(Entry entry) {
        entry(*log_);
        if (__builtin_expect(timing_.is_taped() ? 1 : 0, 0) != 0)
            tape(entry);
        if (__builtin_expect(distances_.empty() ? 1 : 0, 1) == 0)
            tell_distances();
        follow();
    }
    template <class Entry> [[gnu::noinline]] void tape(Entry entry) {
        for (OperationLog* log : timing_.tapes())
            entry(*log);
    }
    /// The accesses of a step, or of an iteration.
    void begin_collecting() {
        collecting_ = true;
        taken_ = timing::no_ports;
    }
    void follow() {
        if (lockstep())
            follow_in_lockstep(is_held_ && !makes_attempts_ ? reached_ : all_steps);
        else if (log_->pending() > log_limit_)
            catch_up();
    }
    void catch_up();
    bool follow_in_lockstep(std::uint64_t end);
    sc_core::sc_time left_until(Cycles cycle) const;
    static void wake_writer(FifoChannel& fifo);
    void wake_behind_flushing();
    void let_out();

    /// Of the loop that begins now.
    unsigned loop_to_run(std::string_view name) const {
        require_outside("begins a loop");
        return loop(name);
    }
    /// Time passes between steps and iterations only.
    void require_outside(char const* what) const {
        if (collecting_ || is_in_tokens_body_ || is_pipelining_)
            refuse_inside(what);
    }
    static constexpr Cycles longest_wait = Cycles{1} << 40U;
    [[noreturn]] void refuse_wait(Cycles cycles) const;
    [[noreturn]] void refuse_number(unsigned loop) const;
    [[noreturn]] void refuse_inside(char const* what) const;
    [[noreturn]] void refuse_later(unsigned port) const;
    void require_loop(char const* what) const {
        if (!is_in_loop_)
            refuse_outside(what);
    }
    [[noreturn]] void refuse_outside(char const* what) const;
    void access_closely(timing::Ports port);
    [[noreturn]] void refuse_in_tokens_body(std::string const& what) const;
    void require_memory(unsigned port) const;
    void require_memory_port() const;
    void require_calling(FifoChannel const& fifo, bool writes) const;
    /// What others do meanwhile is no part of the iteration at hand.
    template <class What> void suspend(What const& what) {
        std::uint32_t const open = std::exchange(open_, 0);
        is_away_ = true;
        sc_core::wait(what);
        is_away_ = false;
        open_ = open;
    }
    [[noreturn]] void refuse_both(std::string const& fifo) const;
    bool is_taken_by_loop() const;
    void enter_memory(unsigned loop);
    void hand_over(FifoEnd::When when);
    bool is_memory(unsigned port) const { return uses_memory() && port == timing_.stream_port(); }
    static timing::Ports read_port_of(FifoChannel const& fifo);
    void require_described_ports() const;
    void require_first_stage(timing::Ports port);
    void tell_distances();
    void require_once(timing::Ports port) const;
    [[noreturn]] void refuse_second(unsigned port) const;
    void require_named(unsigned loop, unsigned port) const;
    bool is_named_by(timing::LoopShape const& loop, unsigned port) const;
    bool is_pipelined(unsigned loop) const;
    bool is_left_out(unsigned loop, std::uint64_t count) const { return count == 0 && is_pipelined(loop); }
    void reach(std::uint64_t iteration);
    void end_body();
    void take_before(std::uint64_t step);
    void end_iteration(std::uint64_t step);
    void drain();
    bool attempts(FifoChannel const& fifo, timing::Ports port, bool only_asks);
    bool attempts_in(timing::Ports port, std::uint64_t step);
    bool decide(timing::Ports port, bool only_asks, std::uint64_t iterations_behind);
    void attempt_later(FifoChannel const& fifo, timing::Ports port, std::function<void(std::uint64_t step)> attempt);
    std::uint64_t step_of(unsigned port) const;
    void tell_ports();
    void tell_behind_attempt(timing::Ports port);
    void reach_step(std::uint64_t step, bool stops_before);
    void require_attempts(FifoChannel const& fifo, timing::Ports port) const;
    static timing::Ports write_port_of(FifoChannel const& fifo);
    void later(FifoChannel const& fifo, std::function<void()> taking);
    void note_end(timing::Ports port);
    std::uint64_t step_of_read(FifoChannel const& fifo) const;
    void put_off(std::uint64_t step, std::function<void()> taking, timing::Ports reads);
    FifoChannel& channel_of(std::size_t fifo) const;

    DataflowCore& dataflow_core_;
    timing::CoreTiming& core_;
    timing::ProcessTiming& timing_;
    timing::OperationLog* log_;  // where it tells what it does
    TimeBase time_base_;
    std::uint64_t ticks_per_cycle_;
    std::vector<FifoChannel*> fifos_;   // by port
    std::size_t log_limit_ = 1U << 16;  ///< operations held before the timing has to catch up
    struct Interlock {
        unsigned loop;
        std::uint32_t dependence;  ///< its number in the loop
        Cycles longest_span;
        WriteDistances const* distances;
    };
    std::vector<Interlock> interlocks_;
    std::vector<std::pair<unsigned, WriteDistances*>> distances_;  // by loop
    timing::LoopEntries entries_;                                  // where there are distances
    std::map<FifoEnd::When, timing::Ports> hand_overs_;
    SourceSite site_;
    bool is_away_ = true;  // its thread waits, or has not begun or is done: who calls now is another
    bool is_in_loop_ = false;
    bool collecting_ = false;
    timing::Ports collected_;

    /// What an iteration of a loop may do without being looked at closely, as masks of ports. None is set where a port
    /// has no mask, nor in a loop that makes attempts.
    struct SoundAccesses {
        std::uint32_t accesses = 0;     ///< if there is one of the port
        std::uint32_t first_reads = 0;  ///< by plain ports, once found to be in the first stage
    };
    SoundAccesses sound_accesses_of(timing::LoopShape const& loop) const;
    std::vector<SoundAccesses> sound_by_loop_;

    // The loop that pipeline() is in. Steps are counted from its begin.
    static constexpr std::uint64_t all_steps = ~std::uint64_t{0};
    struct Taking {
        std::uint64_t step;
        std::function<void()> take;
        timing::Ports reads;  ///< none: an attempt, which does not wait
    };
    std::deque<Taking> takings_;  // of what is read later, in the order of their steps
    unsigned pipelined_ = 0;      // the loop's number
    SoundAccesses sound_;
    std::uint32_t open_ = 0;  // sound accesses that the iteration at hand has not made yet
    timing::Ports taken_;     // read by plain ports in the step or iteration at hand
    bool is_in_tokens_body_ = false;
    bool is_pipelining_ = false;
    bool decides_trip_count_ = false;  // the module, as it goes
    bool is_plain_ = false;            // it has nothing to do between its iterations but to tell of them, in one log
    bool may_wait_ = false;            // its iterations may have to wait for writes of others
    bool has_waited_ = false;          // the module has told what the one at hand waits for
    bool is_held_ = false;             // in lockstep, the process goes no further than the module has got,
    std::uint64_t reached_ = 0;        // which is this step

    // If it makes attempts, it tells of an iteration when that, and all that is done beside it, is over.
    bool makes_attempts_ = false;
    bool has_begun_ = false;  // an iteration
    bool is_draining_ = false;
    timing::Ports told_;                         // of the iteration at hand
    bool is_told_ = false;                       // that it has begun
    std::optional<std::uint64_t> last_attempt_;  // of its body: the step
    timing::Ports attempted_;
    std::vector<bool> may_attempt_;  // by port

    bool has_memory_port_ = false;  // by its description, whether or not there is a memory
    MachineStream const* stream_ = nullptr;
    std::uint64_t tokens_told_ = 0, tokens_accessed_ = 0;  // of memory, by access_memory()
    std::uint64_t tokens_at_hand_ = 0;                     // told, of entries that it has come to
    std::deque<std::uint64_t> entries_told_;               // tokens of the others, if a loop takes them
    std::vector<timing::MemoryBlock> blocks_told_;         // of the loop that is entered next and takes them
    bool tells_ranges_ = false;
};

/// Accesses through plain ports in this scope happen together, as one step.
class Step {
  public:
    explicit Step(ProcessClock& clock, SourceSite site = SourceSite::here()) : clock_(clock) {
        clock_.require_outside("begins a step");
        clock_.here(site);
        clock_.begin_collecting();
    }
    ~Step() noexcept(false) {
        clock_.collecting_ = false;
        clock_.site_ = SourceSite();
        timing::Ports const ports = clock_.collected_;
        clock_.collected_ = timing::Ports();
        if (!ports.is_empty())
            clock_.step(ports);
    }
    Step(Step const&) = delete;
    Step& operator=(Step const&) = delete;

  private:
    ProcessClock& clock_;
};

}  // namespace dataflow
