#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "dataflow/core/time/operation.hpp"

namespace dataflow::timing {

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
    /// All is done of it that is before a step, and unless it stops there, what is in it.
    void reach_step(std::uint64_t step, bool stops_before) {
        append(Operation(Kind::wait, 0, Operation::step_to_reach,
                         static_cast<std::uint32_t>((step << 1U) | (stops_before ? 1U : 0U))));
    }
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
    /// One more iteration like the last one told. False: it differs, or a word cannot count it; iterate() tells it
    /// then.
    bool repeat(Ports::Number ports) {
        Operation& last = operations_.back();
        if (!has_open_end() || !last.repeats(Operation(Kind::iterate, ports, 0, 1)) ||
            last.count() == Operation::longest_count)
            return false;
        last.add(1);
        return true;
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

    /// What was told last, until any of it is taken.
    Operation const& last() const { return operations_.back(); }
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
