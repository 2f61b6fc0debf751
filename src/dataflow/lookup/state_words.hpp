#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "dataflow/core/time/fifo_rules.hpp"
#include "dataflow/core/time/flushing_pipeline.hpp"
#include "dataflow/core/time/operation.hpp"
#include "dataflow/core/time/process_rules.hpp"

namespace dataflow::timing {

/// A group's state as a list of words, so that equal lists have equal futures: of each process its time, its flags, its
/// delay line and its log; of each FIFO its counts, and times. Times are relative to the driver's local time.
using StateWord = std::int32_t;
using StateWords = std::vector<StateWord>;

/// Times further apart make no state.
constexpr std::int64_t furthest_apart = std::int64_t{1} << 28;

/// The words of a state, wherever they are.
struct StateView {
    StateWord const* words = nullptr;
    std::size_t size = 0;

    StateView() = default;
    StateView(StateWord const* first, std::size_t count) : words(first), size(count) {}
    // NOLINTNEXTLINE(google-explicit-constructor): what a view is for
    StateView(StateWords const& list) : words(list.data()), size(list.size()) {}
};

/// What a process's words besides its time, its delay line and its log say.
struct ProcessFlags {
    static constexpr unsigned words = 2;
    static constexpr std::uint64_t most_begun = 0xFF;

    unsigned loop = 0;             ///< that it is in, from 1 on; 0: none
    std::uint64_t begun = 0;       ///< iterations of it, up to as many as count
    Ports::Number next_ports = 0;  ///< of the step it goes on with, a mask; 0: unknown
    bool frozen = false;
    unsigned waits_at = 0;  ///< port at which it is parked, from 1 on; 0: none
    std::size_t left = 0;   ///< operations in its log

    StateWord* put(StateWord* to) const {
        auto const bits = loop | static_cast<std::uint32_t>(begun << 7U) | (std::uint32_t{next_ports} << 15U) |
                          (waits_at << 23U) | (std::uint32_t{frozen} << 27U);
        to[0] = static_cast<StateWord>(bits);
        to[1] = static_cast<StateWord>(left);
        return to + words;
    }
    static ProcessFlags of(StateWord const* from) {
        auto const bits = static_cast<std::uint32_t>(from[0]);
        ProcessFlags flags;
        flags.loop = bits & 0x7F;
        flags.begun = (bits >> 7U) & most_begun;
        flags.next_ports = static_cast<Ports::Number>((bits >> 15U) & 0xFFU);
        flags.waits_at = (bits >> 23U) & 0xF;
        flags.frozen = ((bits >> 27U) & 1U) != 0;
        flags.left = static_cast<std::size_t>(from[1]);
        return flags;
    }
};

/// What a FIFO's words besides its times say. Times that have no effect any more are only counted.
struct FifoCounts {
    static constexpr unsigned words = 2;
    static constexpr std::uint64_t most_tokens = 0xFFFF;

    std::uint64_t tokens = 0;
    std::uint64_t tokens_over = 0;  ///< of them, that can be read whenever their reader gets to them
    std::uint64_t room_over = 0;    ///< writes that wait for nothing

    StateWord* put(StateWord* to) const {
        to[0] = static_cast<StateWord>(tokens | (tokens_over << 16U));
        to[1] = static_cast<StateWord>(room_over);
        return to + words;
    }
    static FifoCounts of(StateWord const* from) {
        auto const bits = static_cast<std::uint32_t>(from[0]);
        return {bits & most_tokens, bits >> 16U, static_cast<std::uint64_t>(from[1])};
    }
};

/// An operation left in a log is two words.
constexpr unsigned words_of_operation = 2;
inline StateWord* put_code(std::uint64_t code, StateWord* to) {
    to[0] = static_cast<StateWord>(static_cast<std::uint32_t>(code));
    to[1] = static_cast<StateWord>(static_cast<std::uint32_t>(code >> 32U));
    return to + words_of_operation;
}
inline std::uint64_t code_of(StateWord const* from) {
    return static_cast<std::uint32_t>(from[0]) | (std::uint64_t{static_cast<std::uint32_t>(from[1])} << 32U);
}

/// Where the words of a state are put down, with times since a base, and how far from it the earliest and the latest
/// of them are.
class StatePage {
  public:
    /// There must be room for so many behind what is put down.
    static constexpr std::size_t slack = 8;

    /// Begins anew, with room for so many words.
    void start(std::int64_t base, std::size_t most_words) {
        if (words_.size() < most_words + slack)
            words_.resize(2 * (most_words + slack));
        next_ = words_.data();
        base_ = base;
        earliest_ = latest_ = 0;
    }
    std::int64_t base() const { return base_; }
    void put(StateWord word) { *next_++ = word; }
    void put_time(std::int64_t time) {
        look_at(time - base_);
        put(static_cast<StateWord>(time - base_));
    }
    /// Of what never falls.
    template <class Line> void put_times(Line const& line, std::uint64_t first, std::uint64_t end) {
        if (first == end)
            return;
        look_at(static_cast<std::int64_t>(line[first]) - base_);
        look_at(static_cast<std::int64_t>(line[end - 1]) - base_);
        line.copy(first, end - first, base_, next_);
        next_ += end - first;
    }
    template <class Flags> void put_flags(Flags const& flags) { next_ = flags.put(next_); }
    void put_operation(std::uint64_t code) { next_ = put_code(code, next_); }

    StateView words() const { return {words_.data(), static_cast<std::size_t>(next_ - words_.data())}; }
    /// The largest distance of a time from the base.
    std::int64_t reach() const { return std::max(-earliest_, latest_); }

  private:
    void look_at(std::int64_t distance) {
        earliest_ = std::min(earliest_, distance);
        latest_ = std::max(latest_, distance);
    }

    StateWords words_;
    StateWord* next_ = nullptr;
    std::int64_t base_ = 0;
    std::int64_t earliest_ = 0, latest_ = 0;
};

/// A token in a flushing pipeline is three words, behind one that tells how many there are, and have left.
constexpr unsigned words_of_flight = 3;
template <class Time> std::size_t words_of(FlushingPipeline<Time> const& flushing) {
    return 1 + words_of_flight * flushing.tokens().size();
}
template <class Time> void save_flushing(FlushingPipeline<Time> const& flushing, StatePage& page) {
    page.put(static_cast<StateWord>(flushing.tokens().size() | flushing.left() << 16U));
    for (auto const& token : flushing.tokens()) {
        page.put(static_cast<StateWord>(token.steps));
        page.put_time(page.base() + static_cast<std::int64_t>(token.frozen));
        page.put(static_cast<StateWord>(2 * token.flight + (token.was_frozen ? 1 : 0)));
    }
}
template <class Time> StateWord const* load_flushing(FlushingPipeline<Time>& flushing, StateWord const* words) {
    auto const counts = static_cast<std::uint32_t>(*words++);
    for (std::uint32_t i = 0; i < (counts & 0xFFFFU); ++i, words += words_of_flight) {
        typename FlushingPipeline<Time>::Token token;
        token.steps = static_cast<Time>(words[0]);
        token.frozen = static_cast<Time>(words[1]);
        token.flight = static_cast<Time>(words[2] >> 1U);
        token.was_frozen = (words[2] & 1) != 0;
        flushing.restore(token, i < counts >> 16U);
    }
    return words;
}

/// Setups that have begun are their number, and when each will be done. One that is done decides nothing: it could as
/// well be done now.
template <class Time> std::size_t words_of_setups(ProcessState<Time> const& state) {
    return 1 + state.setups_done.size();
}
template <class Time> void save_setups(ProcessState<Time> const& state, StatePage& page) {
    page.put(static_cast<StateWord>(state.setups_done.size()));
    for (Time const done : state.setups_done)
        page.put_time(static_cast<std::int64_t>(std::max(done, state.time)));
}
template <class Time> StateWord const* load_setups(std::vector<Time>& setups, Time base, StateWord const* words) {
    for (StateWord left = *words++; left > 0; --left)
        setups.push_back(base + static_cast<Time>(std::int64_t{*words++}));
    return words;
}

/// Waits for writes, of a loop: how many, and of each how many iterations ago it was, and how many steps.
template <class Time> std::size_t words_of_write_waits(ProcessState<Time> const& state) {
    return 1 + 2 * state.write_waits.size();
}
template <class Process> void save_write_waits(Process& process, StatePage& page) {
    auto const& all = process.latest_write_waits();
    page.put(static_cast<StateWord>(all.size()));
    for (auto const& wait : all) {
        page.put(static_cast<StateWord>(static_cast<std::int64_t>(process.state().iterations) - wait.iteration));
        page.put(static_cast<StateWord>(wait.steps));
    }
}
template <class Process> StateWord const* load_write_waits(Process& process, StateWord const* words) {
    auto& all = process.restored_write_waits();
    for (StateWord left = *words++; left > 0; --left, words += 2)
        all.push_back(
            {static_cast<std::int64_t>(process.state().iterations) - words[0], static_cast<Cycles>(words[1])});
    return words;
}

/// What the words of a process say besides where it stands: `flags` has what the process itself does not know.
template <class Process> void save_process(Process& process, ProcessFlags flags, bool with_log, StatePage& page) {
    auto const& state = process.state();
    bool const has_delay_line = process.has_delay_line();
    flags.loop = state.in_loop ? state.loop + 1 : 0;
    flags.begun = state.in_loop ? std::min(state.iterations, process.plan().counting) : 0;
    flags.left = with_log ? process.log().pending() : 0;
    flags.frozen ? page.put(0) : page.put_time(static_cast<std::int64_t>(state.time));
    page.put_flags(flags);
    for (std::uint64_t lag = 1; has_delay_line && lag <= process.plan().longest_lag; ++lag)
        page.put(state.pipeline.iteration < lag ? 0 : state.delayed(lag));
    if (process.flushes())
        save_flushing(state.flushing, page);
    if (process.sets_up_ahead())
        save_setups(state, page);
    if (process.has_interlocks())
        save_write_waits(process, page);
    for (std::size_t i = 0; i < flags.left; ++i)
        page.put_operation(process.log().begin()[i].code());
}

/// At most, with what its log holds now.
template <class Process> std::size_t most_words_of(Process const& process, ProcessShape const& shape) {
    std::uint64_t longest_lag = 0;
    for (LoopPlan const& plan : shape.plans)
        longest_lag = std::max(longest_lag, plan.longest_lag);
    return 1 + ProcessFlags::words + longest_lag + (process.flushes() ? words_of(process.state().flushing) : 0) +
           (process.sets_up_ahead() ? words_of_setups(process.state()) : 0) +
           (process.has_interlocks() ? words_of_write_waits(process.state()) : 0) +
           words_of_operation * process.log().pending();
}

/// Puts the operations that are left in front of the log of the process. Returns the words behind its own.
template <class Process>
StateWord const* load_process(Process& process, typename Process::Time base, StateWord const* words,
                              ProcessFlags& flags) {
    auto const time = base + static_cast<typename Process::Time>(std::int64_t{*words++});
    flags = ProcessFlags::of(words);
    words += ProcessFlags::words;
    process.restore(time, flags.loop, flags.begun);
    bool const has_delay_line = process.has_delay_line();
    for (std::uint64_t lag = 1; has_delay_line && lag <= process.plan().longest_lag; ++lag)
        process.restore_delayed(lag, static_cast<Ports::Number>(*words++));
    if (process.flushes())
        words = load_flushing(process.restored_flushing(), words);
    if (process.sets_up_ahead())
        words = load_setups(process.restored_setups(), base, words);
    if (process.has_interlocks())
        words = load_write_waits(process, words);
    for (std::size_t i = flags.left; i > 0; --i)
        process.put_back(Operation(code_of(words + words_of_operation * (i - 1))));
    return words + words_of_operation * flags.left;
}

/// A token is there at the end of a cycle, which its FIFO's occupancy counts, if it is read later. Where it can be read
/// in the cycle in which it is written, it has to be older than the reader's present for that to be sure.
template <class Line> std::int64_t age_that_shows(FifoRules<Line> const& fifo) {
    return fifo.read_latency == 0 ? 1 : 0;
}

/// Of its times only those that are not over, when neither end does anything before `reads_from` and `writes_from`: a
/// time before that decides nothing, it could as well be that time. Where a frozen writer finds room, Transition::Room
/// tells.
template <class Line>
void save_fifo(FifoRules<Line> const& fifo, std::int64_t reads_from, std::int64_t writes_from, bool writer_is_frozen,
               StatePage& page) {
    if (writer_is_frozen)
        writes_from = std::numeric_limits<std::int64_t>::max();
    FifoCounts counts;
    counts.tokens = fifo.readable.known();
    counts.tokens_over = fifo.readable.count_until(reads_from - age_that_shows(fifo));
    counts.room_over = fifo.free.count_until(writes_from);
    page.put_flags(counts);
    page.put_times(fifo.readable, counts.tokens_over, counts.tokens);
    page.put_times(fifo.free, counts.room_over, fifo.free.known());
}

/// Returns the words behind those of the FIFO. Times that are over become `reads_from` and `writes_from`, where a line
/// tells them.
template <class Line>
StateWord const* load_fifo(FifoRules<Line>& fifo, typename Line::Time base, typename Line::Time reads_from,
                           typename Line::Time writes_from, StateWord const* words) {
    FifoCounts const counts = FifoCounts::of(words);
    words += FifoCounts::words;
    std::uint64_t const tokens = counts.tokens - counts.tokens_over;
    std::uint64_t const writes = fifo.room - counts.tokens - counts.room_over;
    auto const over = static_cast<typename Line::Time>(static_cast<std::int64_t>(reads_from) - age_that_shows(fifo));
    fifo.readable.load_end(counts.tokens_over, over, tokens, base, words);
    fifo.free.load_front(counts.room_over, writes_from, writes, base, words + tokens);
    return words + tokens + writes;
}

}  // namespace dataflow::timing
