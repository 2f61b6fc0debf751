#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

#include "dataflow/core/time/ports.hpp"

namespace dataflow::timing {

/// What a process does to the time, independent of how long it takes: the alphabet of
/// docs/timing-model.md#sources-of-time. Which ports it accesses is the number of a set, see Ports. One word: a run
/// logs millions of them, and compares them as words.
class Operation {
  public:
    enum class Kind : std::uint8_t {
        wait,     ///< T += count; with a gap: setup(), begin_setup(), await_setup(), await_write() or a choice
        step,     ///< the accesses of `ports` together, then T += count
        enter,    ///< enter pipelined loop number `count`
        iterate,  ///< `count` times: an iteration that accesses `ports`, then `gap` iterations that access nothing;
                  ///< if tail_ports is not 0, then an iteration that accesses those, and `tail_gap` that access nothing
        leave,    ///< drain the loop and leave it
        stamp,    ///< note the local time
        mixed,    ///< `length` iterations that access `ports`, the i-th with a silent one behind it if bit i of `gaps`
        flanked,  ///< iterate with a tail, and one more iteration that accesses tail_ports behind the first of `count`
    };
    using Code = std::uint64_t;
    static constexpr std::uint32_t longest_count = (1U << 19) - 1;
    static constexpr std::uint32_t longest_gap = (1U << 10) - 1;
    static constexpr unsigned longest_mix = 32;

    Operation() = default;
    explicit Operation(Code code) : code_(code) {}
    Operation(Kind kind, Ports::Number ports, std::uint32_t gap, std::uint32_t count)
        : code_((Code{static_cast<std::uint8_t>(kind)} << kind_at) | (Code{ports} << ports_at) | (Code{gap} << gap_at) |
                count) {}
    static Operation mix(Ports::Number ports, unsigned length, std::uint32_t gaps) {
        return Operation((Code{static_cast<std::uint8_t>(Kind::mixed)} << kind_at) | (Code{ports} << ports_at) |
                         (Code{length} << length_at) | gaps);
    }

    Code code() const { return code_; }
    Kind kind() const { return static_cast<Kind>(code_ >> kind_at); }
    Ports::Number ports() const { return static_cast<Ports::Number>((code_ >> ports_at) & port_bits); }
    Ports::Number tail_ports() const { return kind() == Kind::mixed ? Ports::Number{0} : own_tail_ports(); }
    /// tail_ports() of what is no mix.
    Ports::Number own_tail_ports() const { return static_cast<Ports::Number>((code_ >> tail_ports_at) & port_bits); }
    /// Of what is no mix: a tail accesses one port, the last of several that other iterations access.
    bool has_last_port_as_tail() const {
        std::uint32_t const tail = own_tail_ports();
        return tail != 0 && Ports::is_mask(ports()) && ports() > tail && ports() < 2 * tail && (ports() & tail) != 0 &&
               (tail & (tail - 1)) == 0;
    }
    /// The bits of a code that are set if one of `ports`, as bits of numbers, is accessed; not for a mix.
    static Code at_ports(Ports::Number ports) { return (Code{ports} << ports_at) | (Code{ports} << tail_ports_at); }
    /// Not 0 if it accesses anything; beyond a mask if it accesses ports that no mask has.
    Ports::Number all_ports() const { return static_cast<Ports::Number>(ports() | tail_ports()); }
    /// Whether it is an access of ports of which masks tell, one of those of `mask` among them; no tail.
    bool is_at(std::uint32_t mask) const { return Ports::is_mask(ports()) && (ports() & mask) != 0; }
    std::uint32_t gap() const { return static_cast<std::uint32_t>(code_ >> gap_at) & longest_gap; }
    std::uint32_t tail_gap() const { return static_cast<std::uint32_t>(code_ >> tail_gap_at) & longest_gap; }
    std::uint32_t count() const { return static_cast<std::uint32_t>(code_) & longest_count; }
    unsigned length() const { return static_cast<unsigned>(code_ >> length_at) & 0x3FU; }
    std::uint32_t gaps() const { return static_cast<std::uint32_t>(code_); }

    void subtract(std::uint32_t count) { code_ -= count; }
    void add(std::uint32_t count) { code_ += count; }
    void add_gap(std::uint32_t count) { code_ += Code{count} << gap_at; }
    void add_tail_gap(std::uint32_t count) { code_ += Code{count} << tail_gap_at; }
    void add_tail(Ports::Number ports, std::uint32_t gap) {
        code_ |= (Code{ports} << tail_ports_at) | (Code{gap} << tail_gap_at);
    }
    /// Equal but for the count, and without a tail.
    bool repeats(Operation const& other) const { return ((code_ ^ other.code_) & ~Code{longest_count}) == 0; }
    /// The first `count` iterations of an iterate or a mix, without a tail.
    Operation first(std::uint32_t count) const {
        return kind() == Kind::mixed ? mix(ports(), count, gaps() & gap_bits(1, count))
                                     : Operation(kind(), ports(), gap(), count);
    }
    /// What is left once all `count` iterations are done.
    void become_tail() { *this = Operation(Kind::iterate, tail_ports(), tail_gap(), 1); }

    /// Of a flanked one, `count` at least 2: the first iteration with the one behind it, and all others.
    Operation head() const {
        Operation head(Kind::iterate, ports(), 0, 1);
        head.add_tail(tail_ports(), 0);
        return head;
    }
    /// What a wait does: its gap. From first_dependence on, it is await_write() for the dependence of that number.
    /// The last ones are choices: what a loop says that makes attempts, and an attempt itself, in a loop or outside.
    enum WaitFor : std::uint32_t {
        cycles,
        whole_setup,
        setup_begin,
        setup_end,
        first_dependence,
        call_start = longest_gap - 4,
        step_to_reach = longest_gap - 3,
        end_of_window,
        ports_of_window,
        attempt,
    };
    bool is_plain_wait() const { return gap() == cycles; }
    bool is_call_start() const { return kind() == Kind::wait && gap() == call_start; }
    bool is_choice() const { return kind() == Kind::wait && gap() >= step_to_reach; }
    /// Of an attempt: whether it found what it looked for, and moved a token if it did; and how many iterations its own
    /// is behind the one at hand.
    bool succeeded() const { return (count() & 1U) != 0; }
    bool only_asked() const { return (count() & 2U) != 0; }
    std::uint32_t iterations_behind() const { return count() >> 2U; }
    /// Of a wait: what await_write() says, and the number of its dependence.
    bool awaits_write() const { return gap() >= first_dependence && gap() < call_start; }
    std::uint32_t dependence() const { return gap() - first_dependence; }
    /// Says nothing besides what its kind can mean.
    bool is_well_formed() const {
        switch (kind()) {
            case Kind::wait:
            case Kind::iterate:
                return tail_ports() != 0 || tail_gap() == 0;
            case Kind::step:
            case Kind::enter:
            case Kind::flanked:
                return gap() == 0 && (tail_ports() != 0 || tail_gap() == 0);
            case Kind::leave:
            case Kind::stamp:
                return gap() == 0 && tail_ports() == 0 && tail_gap() == 0 && count() == 0;
            case Kind::mixed:
                return code_ == mix(ports(), length(), gaps()).code_;
        }
        return false;
    }
    Operation rest() const {
        Operation rest(Kind::iterate, ports(), 0, count() - 1);
        rest.add_tail(tail_ports(), tail_gap());
        return rest;
    }

    /// Iterations of a loop that it says.
    std::uint64_t iterations() const {
        if (kind() == Kind::mixed)
            return length() + static_cast<unsigned>(__builtin_popcount(gaps()));
        if (kind() != Kind::iterate && kind() != Kind::flanked)
            return 0;
        std::uint64_t const tail = own_tail_ports() == 0 ? 0 : 1U + tail_gap();
        return std::uint64_t{count()} * (1U + gap()) + tail + (kind() == Kind::flanked ? 1U : 0U);
    }

    /// How many of the first `count` iterations of a mix are like the first: all with a silent one behind, or none.
    static unsigned alike(std::uint32_t gaps, unsigned count) {
        std::uint32_t const others = (gaps & 1U) != 0 ? ~gaps : gaps;
        return others == 0 ? count : std::min(count, static_cast<unsigned>(__builtin_ctz(others)));
    }
    /// `count` iterations with a silent one behind each, or without, as bits of a mix.
    static std::uint32_t gap_bits(unsigned gap, std::uint32_t count) {
        return gap == 0 || count == 0 ? 0 : ~std::uint32_t{0} >> (longest_mix - count);
    }

  private:
    static constexpr unsigned kind_at = 61, ports_at = 50, tail_ports_at = 39, gap_at = 29, tail_gap_at = 19;
    static constexpr unsigned length_at = 44;
    static constexpr Code port_bits = Ports::numbers - 1;

    Code code_ = 0;
};

/// The operations of one process, in program order, waiting for their time. Neighbours are joined where one operation
/// can say the same.
class OperationLog {
  public:
    using Kind = Operation::Kind;

    void wait(std::uint32_t cycles) {
        Operation& last = operations_.back();
        bool const extends =
            has_open_end() && last.gap() == 0 && (last.kind() == Kind::step || last.kind() == Kind::wait);
        if (extends && last.count() + cycles <= Operation::longest_count)
            last.add(cycles);
        else
            append(Operation(Kind::wait, 0, 0, cycles));
    }
    void step(Ports::Number ports, std::uint32_t cycles_after) {
        append(Operation(Kind::step, ports, 0, cycles_after));
    }
    /// T += what a setup of this process takes, whatever that is.
    void setup() { append(Operation(Kind::wait, 0, Operation::whole_setup, 1)); }
    /// Outside loops: a call waits for its begin, see CallStart.
    void await_call() { append(Operation(Kind::wait, 0, Operation::call_start, 0)); }
    /// Between iterations of a loop: a setup begins, and takes its time beside the loop.
    void begin_setup() { append(Operation(Kind::wait, 0, Operation::setup_begin, 1)); }
    /// Between iterations: the loop stands still until the oldest setup begun, and not awaited yet, is done.
    void await_setup() { append(Operation(Kind::wait, 0, Operation::setup_end, 1)); }
    /// Between iterations: the next one accesses what the one `distance` before it writes. The loop waits until it
    /// may, if that is a dependence that it waits for.
    void await_write(std::uint32_t dependence, std::uint32_t distance) {
        append(Operation(Kind::wait, 0, Operation::first_dependence + dependence, distance));
    }
    // A loop that makes attempts tells of each iteration that makes any, or waits for one, in parts: `ports_of_window`,
    // attempts, and then iterate() with the same ports and more.

    /// The iteration at hand accesses `ports`, besides others that are told later.
    void add_ports(Ports::Number ports) { append(Operation(Kind::wait, ports, Operation::ports_of_window, 0)); }
    /// All is done of it that is before a step, or in it; twice its number, and 1 if only what is before.
    void reach_step(std::uint32_t code) { append(Operation(Kind::wait, 0, Operation::step_to_reach, code)); }
    /// While a loop drains: the steps of an iteration more are over.
    void end_window() { append(Operation(Kind::wait, 0, Operation::end_of_window, 0)); }
    /// A non-blocking access, in the step of its port.
    void attempt(Ports::Number port, bool succeeded, bool only_asked, std::uint32_t iterations_behind) {
        append(Operation(Kind::wait, port, Operation::attempt,
                         (iterations_behind << 2U) | (only_asked ? 2U : 0U) | (succeeded ? 1U : 0U)));
    }
    void enter(std::uint32_t loop) { append(Operation(Kind::enter, 0, 0, loop)); }
    void leave() { append(Operation(Kind::leave, 0, 0, 0)); }
    void stamp() { append(Operation(Kind::stamp, 0, 0, 0)); }
    void iterate(Ports::Number ports, std::uint32_t gap, std::uint32_t count) {
        if (count > 0 && !(has_open_end() && extend(operations_.back(), ports, gap, count)))
            append(Operation(Kind::iterate, ports, gap, count));
    }
    /// iterate(), then one iteration that accesses `tail_ports`, and `tail_gap` that access nothing.
    void iterate_with_tail(Ports::Number ports, std::uint32_t count, Ports::Number tail_ports, std::uint32_t tail_gap) {
        iterate_with_tail(Kind::iterate, ports, count, tail_ports, tail_gap);
    }
    /// An iteration that accesses `ports`, one that accesses `tail_ports`, and iterate_with_tail() for the other
    /// `count` - 1, which is not 0.
    void iterate_flanked(Ports::Number ports, std::uint32_t count, Ports::Number tail_ports, std::uint32_t tail_gap) {
        iterate_with_tail(Kind::flanked, ports, count, tail_ports, tail_gap);
    }
    void iterate_mixed(Ports::Number ports, unsigned length, std::uint32_t gaps) {
        if (gaps == 0 || gaps == Operation::gap_bits(1, length))
            iterate(ports, gaps & 1U, length);
        else
            append(Operation::mix(ports, length, gaps));
    }
    void append(Operation const& operation) { operations_.push_back(operation); }

    bool exhausted() const { return next_ == operations_.size(); }
    std::size_t pending() const { return operations_.size() - next_; }
    /// The front operation, never a mix or a flanked one: what is simple at its start is split off.
    Operation& front() {
        if (operations_[next_].kind() >= Kind::mixed)
            split_front();
        return operations_[next_];
    }
    Operation const& front() const { return operations_[next_]; }
    /// With nothing split off.
    Operation& whole_front() { return operations_[next_]; }

    // Who tells and who takes need not be of one mind: operations may be taken out and put back in another form.

    /// Takes out what was told since note_taken(). False: nothing.
    bool take_told(std::vector<Operation>& told) {
        std::size_t const first = std::max(next_, taken_);
        told.assign(operations_.begin() + static_cast<std::ptrdiff_t>(first), operations_.end());
        operations_.resize(first);
        return !told.empty();
    }
    /// What there is now is not extended any more.
    void note_taken() { taken_ = operations_.size(); }

    /// Takes the front operation out. Keeps the storage, and a harmless first entry for the mergers to look at.
    void consume() {
        if (++next_ == operations_.size())
            clear();
    }

    /// The pending() operations, from the front.
    Operation const* begin() const { return operations_.data() + next_; }

    /// Takes `whole` operations out, and `part` iterations of the one behind them, which has more.
    void consume(std::size_t whole, std::uint32_t part) {
        next_ += whole;
        if (part > 0) {
            Operation& operation = operations_[next_];
            if (operation.kind() == Kind::mixed)
                operation = Operation::mix(operation.ports(), operation.length() - part, operation.gaps() >> part);
            else if (operation.count() > part)
                operation.subtract(part);
            else
                operation.become_tail();
        }
        if (exhausted())
            clear();
    }

    /// Splits the front operation, so that the front one is a single iteration that accesses something, or iterations
    /// that access nothing, or no iteration at all.
    void split_iteration() {
        Operation const operation = front();
        if (operation.kind() != Kind::iterate || operation.ports() == 0)
            return;
        bool const is_last = operation.count() == 1 && operation.tail_ports() == 0;
        consume(is_last ? 1 : 0, is_last ? 0 : 1);
        if (operation.gap() > 0)
            put_back(Operation(Kind::iterate, 0, 0, operation.gap()));
        put_back(Operation(Kind::iterate, operation.ports(), 0, 1));
    }

    /// Puts an operation in front of all others.
    void put_back(Operation const& operation) {
        if (next_ > 1) {
            operations_[--next_] = operation;
        } else {
            operations_.insert(operations_.begin() + 1, operation);
            ++taken_;
        }
    }

    void clear() {
        operations_.resize(1);
        operations_.front() = Operation{};
        next_ = taken_ = 1;
    }

    /// Gives back the room of operations long gone, so that a process that is always ahead does not fill the memory.
    void compact() {
        if (next_ > 4096 && 2 * next_ > operations_.size()) {
            operations_.erase(operations_.begin() + 1, operations_.begin() + static_cast<std::ptrdiff_t>(next_));
            taken_ -= std::min(taken_, next_) - 1;
            next_ = 1;
        }
    }

  private:
    static constexpr std::uint32_t longest_part_of_mix = 16;

    void iterate_with_tail(Kind kind, Ports::Number ports, std::uint32_t count, Ports::Number tail_ports,
                           std::uint32_t tail_gap) {
        std::uint32_t const gap = std::min(tail_gap, Operation::longest_gap);
        Operation operation(kind, ports, 0, count);
        operation.add_tail(tail_ports, gap);
        append(operation);
        iterate(0, 0, tail_gap - gap);
    }

    void split_front() {
        Operation const operation = operations_[next_];
        if (operation.kind() == Kind::mixed) {
            split_mix();
            return;
        }
        operations_[next_] = operation.rest();
        put_back(operation.head());
    }

    void split_mix() {
        Operation& mix = operations_[next_];
        std::uint32_t const gaps = mix.gaps();
        unsigned const equal = Operation::alike(gaps, mix.length());
        Operation const run(Kind::iterate, mix.ports(), gaps & 1U, equal);
        if (equal == mix.length()) {
            mix = run;
        } else {
            mix = Operation::mix(mix.ports(), mix.length() - equal, gaps >> equal);
            put_back(run);
        }
    }

    /// Makes iterations part of the last operation, if its pattern allows. The front one may be under way: what it has
    /// begun stays.
    [[gnu::always_inline]] bool extend(Operation& last, Ports::Number ports, std::uint32_t gap, std::uint32_t count) {
        Operation const more(Kind::iterate, ports, gap, count);
        if (last.repeats(more)) {
            if (last.count() + count > Operation::longest_count)
                return false;
            last.add(count);
            return true;
        }
        bool const under_way = operations_.size() == next_ + 1;
        if (!under_way && ports != 0 && ports == last.ports())
            return extend_mix(last, gap, count) || extend_tail(last, ports, gap, count);
        bool const is_plain = last.kind() == Kind::iterate;
        if ((!is_plain && last.kind() != Kind::flanked) || last.ports() == 0)
            return false;
        if (ports != 0)
            return extend_tail(last, ports, gap, count);
        if (gap != 0)
            return false;
        if (last.tail_ports() != 0) {
            if (last.tail_gap() + count > Operation::longest_gap)
                return false;
            last.add_tail_gap(count);
            return true;
        }
        if (under_way || last.count() != 1 || last.gap() + count > Operation::longest_gap)
            return false;
        last.add_gap(count);
        return true;
    }

    bool extend_tail(Operation& last, Ports::Number ports, std::uint32_t gap, std::uint32_t count) {
        if (count != 1 || last.kind() != Kind::iterate || last.tail_ports() != 0 || last.ports() == 0)
            return false;
        last.add_tail(ports, gap);
        return true;
    }

    /// Short runs with and without gaps are kept together.
    bool extend_mix(Operation& last, std::uint32_t gap, std::uint32_t count) {
        if (gap > 1 || count > longest_part_of_mix)
            return false;
        bool const is_mix = last.kind() == Kind::mixed;
        if (!is_mix && (last.kind() != Kind::iterate || last.tail_ports() != 0 || last.gap() > 1 ||
                        last.count() > longest_part_of_mix))
            return false;
        unsigned const length = is_mix ? last.length() : last.count();
        if (length + count > Operation::longest_mix)
            return false;
        std::uint32_t const before = is_mix ? last.gaps() : Operation::gap_bits(last.gap(), last.count());
        std::uint32_t const behind = Operation::gap_bits(gap, count);
        last = Operation::mix(last.ports(), length + count, before | (length == 32 ? 0 : behind << length));
        return true;
    }

    /// Its last operation may become longer.
    bool has_open_end() const { return operations_.size() > next_ && operations_.size() > taken_; }

    std::vector<Operation> operations_{Operation{}};
    std::size_t next_ = 1;
    std::size_t taken_ = 1;  ///< up to here, operations are as they were put back
};

}  // namespace dataflow::timing
