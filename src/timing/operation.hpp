#pragma once
#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

namespace faster::timing {

/// What a process does to the time, independent of how long it takes: the alphabet of the contract's table. A port mask
/// has one bit per port of the process, in the program order of a step.
struct Operation {
    enum class Kind : std::uint8_t {
        wait,     ///< T += count
        step,     ///< the accesses of `ports` together, then T += count
        enter,    ///< enter pipelined loop number `count`
        iterate,  ///< `count` times: an iteration that accesses `ports`, then `gap` iterations that access nothing;
                  ///< if tail_ports is not 0, then an iteration that accesses those, and `tail_gap` that access nothing
        leave,    ///< drain the loop and leave it
        stamp,    ///< note the local time
        mixed,    ///< iterations that access `ports`, each with or without one behind it that accesses nothing
    };
    static constexpr unsigned longest_mix = 32;
    Kind kind = Kind::wait;
    std::uint8_t ports = 0;
    std::uint8_t tail_ports = 0;
    std::uint16_t gap = 0;
    std::uint16_t tail_gap = 0;
    std::uint32_t count = 0;

    bool accesses() const { return ports != 0; }
    /// Of a mix: how many iterations access something, and which of them, a bit each, have a silent one behind them.
    unsigned length() const { return gap; }
    std::uint32_t gaps() const { return count; }
    void set_mix(unsigned length, std::uint32_t gaps) {
        gap = static_cast<std::uint16_t>(length);
        count = gaps;
    }
    /// `count` iterations with a silent one behind each, or without, as bits of a mix.
    static std::uint32_t gap_bits(unsigned gap, std::uint32_t count) {
        return gap == 0 ? 0 : ~std::uint32_t{0} >> (longest_mix - count);
    }
    /// What is left once all `count` iterations are done.
    void become_tail() {
        ports = tail_ports;
        gap = tail_gap;
        count = 1;
        tail_ports = 0;
        tail_gap = 0;
    }
};

/// The operations of one process, in program order, waiting for their time. Equal neighbours are kept as one.
class OperationLog {
  public:
    void wait(std::uint32_t cycles) {
        Operation& last = operations_.back();
        bool const extends = !exhausted() && (last.kind == Operation::Kind::step || last.kind == Operation::Kind::wait);
        if (extends && last.count <= std::numeric_limits<std::uint32_t>::max() - cycles)
            last.count += cycles;
        else
            push(Operation::Kind::wait, 0, 0, cycles);
    }
    void step(std::uint8_t ports, std::uint32_t cycles_after) {
        push(Operation::Kind::step, ports, 0, cycles_after);
    }
    void enter(std::uint32_t loop) { push(Operation::Kind::enter, 0, 0, loop); }
    void leave() { push(Operation::Kind::leave, 0, 0, 0); }
    void stamp() { push(Operation::Kind::stamp, 0, 0, 0); }

    void iterate(std::uint8_t ports, std::uint16_t gap, std::uint32_t count) {
        if (count > 0 && !(operations_.size() > next_ && extend(operations_.back(), ports, gap, count)))
            push(Operation::Kind::iterate, ports, gap, count);
    }

    void append(Operation const& operation) { operations_.push_back(operation); }

    bool exhausted() const { return next_ == operations_.size(); }
    std::size_t pending() const { return operations_.size() - next_; }
    /// The front operation, never a mix: equal iterations at its start are split off.
    Operation& front() {
        if (operations_[next_].kind == Operation::Kind::mixed)
            split_mix();
        return operations_[next_];
    }
    Operation const& front() const { return operations_[next_]; }

    /// Takes the front operation out. Keeps the storage, and a harmless first entry for the mergers to look at.
    void consume() {
        if (++next_ == operations_.size())
            reset();
    }

    /// The i-th operation from the front; i below pending().
    Operation const& at(std::size_t i) const { return operations_[next_ + i]; }

    /// Takes `whole` operations out, and `part` iterations of the one behind them, which has more.
    void consume(std::size_t whole, std::uint32_t part) {
        next_ += whole;
        if (part > 0 && operations_[next_].kind == Operation::Kind::mixed) {
            Operation& mix = operations_[next_];
            mix.set_mix(mix.length() - part, mix.gaps() >> part);
        } else if (part > 0) {
            Operation& operation = operations_[next_];
            operation.count -= part;
            if (operation.count == 0)
                operation.become_tail();
        }
        if (exhausted())
            reset();
    }

    /// Puts an operation in front of all others.
    void put_back(Operation const& operation) {
        if (next_ > 1)
            operations_[--next_] = operation;
        else
            operations_.insert(operations_.begin() + 1, operation);
    }

    void clear() { reset(); }

    /// Gives back the room of operations long gone, so that a process that is always ahead does not fill the memory.
    void compact() {
        if (next_ > 4096 && 2 * next_ > operations_.size()) {
            operations_.erase(operations_.begin() + 1, operations_.begin() + static_cast<std::ptrdiff_t>(next_));
            next_ = 1;
        }
    }

  private:
    static constexpr std::uint32_t longest_gap = 0xFFF;
    static constexpr std::uint32_t longest_part_of_mix = 16;

    void push(Operation::Kind kind, std::uint8_t ports, std::uint16_t gap, std::uint32_t count) {
        Operation operation;
        operation.kind = kind;
        operation.ports = ports;
        operation.gap = gap;
        operation.count = count;
        operations_.push_back(operation);
    }

    void split_mix() {
        Operation& mix = operations_[next_];
        std::uint32_t const gaps = mix.gaps();
        bool const gap = (gaps & 1U) != 0;
        std::uint32_t const others = gap ? ~gaps : gaps;
        unsigned const equal = std::min<unsigned>(mix.length(), others == 0 ? Operation::longest_mix
                                                                            : static_cast<unsigned>(__builtin_ctz(others)));
        Operation run;
        run.kind = Operation::Kind::iterate;
        run.ports = mix.ports;
        run.gap = gap ? 1 : 0;
        run.count = equal;
        if (equal == mix.length()) {
            mix = run;
        } else {
            mix.set_mix(mix.length() - equal, gaps >> equal);
            put_back(run);
        }
    }

    /// Short runs with and without gaps are kept together.
    bool extend_mix(Operation& last, std::uint8_t ports, std::uint16_t gap, std::uint32_t count) {
        bool const is_mix = last.kind == Operation::Kind::mixed;
        if (last.ports != ports || gap > 1 || count > longest_part_of_mix)
            return false;
        if (!is_mix && (last.kind != Operation::Kind::iterate || last.tail_ports != 0 || last.gap > 1 ||
                        last.gap == gap || last.count > longest_part_of_mix))
            return false;
        unsigned const length = is_mix ? last.length() : last.count;
        if (length + count > Operation::longest_mix)
            return false;
        std::uint32_t const before = is_mix ? last.gaps() : Operation::gap_bits(last.gap, last.count);
        last.kind = Operation::Kind::mixed;
        last.set_mix(length + count, before | (Operation::gap_bits(gap, count) << length));
        return true;
    }

    /// Makes iterations part of the last operation, if its pattern allows. The front one may be under way: what it has
    /// begun stays.
    bool extend(Operation& last, std::uint8_t ports, std::uint16_t gap, std::uint32_t count) {
        bool const under_way = operations_.size() == next_ + 1;
        if (ports != 0 && !under_way && extend_mix(last, ports, gap, count))
            return true;
        if (last.kind != Operation::Kind::iterate)
            return false;
        bool const silent = ports == 0 && gap == 0;
        if (last.tail_ports != 0) {
            if (!silent || last.tail_gap + count > longest_gap)
                return false;
            last.tail_gap = static_cast<std::uint16_t>(last.tail_gap + count);
        } else if (last.ports == ports && last.gap == gap) {
            if (last.count > std::numeric_limits<std::uint32_t>::max() - count)
                return false;
            last.count += count;
        } else if (silent && last.ports != 0 && last.count == 1 && !under_way && last.gap + count <= longest_gap) {
            last.gap = static_cast<std::uint16_t>(last.gap + count);
        } else if (ports != 0 && count == 1 && last.ports != 0 && gap <= longest_gap) {
            last.tail_ports = ports;
            last.tail_gap = gap;
        } else {
            return false;
        }
        return true;
    }

    void reset() {
        operations_.resize(1);
        operations_.front() = Operation{};
        next_ = 1;
    }

    std::vector<Operation> operations_{Operation{}};
    std::size_t next_ = 1;
};

}  // namespace faster::timing
