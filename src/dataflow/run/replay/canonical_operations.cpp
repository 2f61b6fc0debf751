#include "dataflow/run/replay/canonical_operations.hpp"

#include <algorithm>

namespace dataflow::replay {

namespace {

using timing::Operation;

/// Takes iterations of the same ports as runs of equal ones, and gives them back as few operations.
class IterationJoiner {
  public:
    explicit IterationJoiner(std::vector<Operation>& operations) : operations_(operations) {}

    void add(timing::Ports::Number ports, std::uint32_t gap, std::uint32_t count) {
        if (ports != ports_)
            flush();
        ports_ = ports;
        if (count_ > 0 && gap != gap_)
            end_run();
        gap_ = gap;
        count_ += count;
    }

    /// Adds all runs of a mix. Those between its first and its last cannot grow: they fill mixes as they are.
    void add_mix(timing::Ports::Number ports, std::uint32_t gaps, unsigned length) {
        unsigned const first = Operation::alike(gaps, length);
        add(ports, gaps & 1U, first);
        if (first == length)
            return;
        gaps >>= first;
        length -= first;
        std::uint32_t const last_gap = gaps >> (length - 1);
        std::uint32_t const others = (last_gap != 0 ? ~gaps : gaps) & ((1U << length) - 1);
        unsigned const between = others == 0 ? 0 : 32U - static_cast<unsigned>(__builtin_clz(others));
        if (between > 0) {
            end_run();
            fill_mix(gaps & ((1U << between) - 1), between);
        }
        add(ports, last_gap, length - between);
    }

    void flush() {
        end_run();
        end_mix();
    }

  private:
    void fill_mix(std::uint32_t gaps, unsigned length) {
        unsigned const fit = std::min(length, Operation::longest_mix - length_);
        gaps_ |= gaps << length_;
        length_ += fit;
        if (length_ < Operation::longest_mix)
            return;
        end_mix();
        gaps_ = gaps >> fit;
        length_ = length - fit;
    }

    /// Long runs stand for themselves, short ones fill mixes.
    void end_run() {
        if (count_ > Operation::longest_mix)
            end_mix();
        for (; count_ > Operation::longest_mix; count_ -= std::min<std::uint64_t>(count_, Operation::longest_count))
            operations_.emplace_back(
                Operation::Kind::iterate, ports_, gap_,
                static_cast<std::uint32_t>(std::min<std::uint64_t>(count_, Operation::longest_count)));
        while (count_ > 0) {
            auto const fit = static_cast<unsigned>(std::min<std::uint64_t>(count_, Operation::longest_mix - length_));
            gaps_ |= Operation::gap_bits(gap_, fit) << length_;
            count_ -= fit;
            length_ += fit;
            if (length_ == Operation::longest_mix)
                end_mix();
        }
    }

    void end_mix() {
        bool const is_run = gaps_ == 0 || gaps_ == Operation::gap_bits(1, length_);
        if (length_ > 0)
            operations_.push_back(is_run ? Operation(Operation::Kind::iterate, ports_, gaps_ & 1U, length_)
                                         : Operation::mix(ports_, length_, gaps_));
        gaps_ = 0;
        length_ = 0;
    }

    std::vector<Operation>& operations_;
    timing::Ports::Number ports_ = 0;
    std::uint32_t gap_ = 0;
    std::uint64_t count_ = 0;
    std::uint32_t gaps_ = 0;
    unsigned length_ = 0;
};

bool is_simple(Operation const& operation) {
    if (operation.kind() != Operation::Kind::iterate)
        return operation.kind() == Operation::Kind::mixed;
    timing::Ports::Number const tail = operation.own_tail_ports();
    return operation.ports() != 0 && operation.gap() <= 1 &&
           (tail == 0 || (tail == operation.ports() && operation.tail_gap() <= 1));
}

void add(Operation const& operation, IterationJoiner& joiner) {
    if (operation.kind() == Operation::Kind::mixed) {
        joiner.add_mix(operation.ports(), operation.gaps(), operation.length());
        return;
    }
    joiner.add(operation.ports(), operation.gap(), operation.count());
    if (operation.tail_ports() != 0)
        joiner.add(operation.ports(), operation.tail_gap(), 1);
}

}  // namespace

std::vector<Operation> canonical(Operation const* first, std::size_t count) {
    std::vector<Operation> operations;
    operations.reserve(count + 1);
    IterationJoiner joiner(operations);
    Operation const* const end = first + count;
    bool is_open = false;
    bool next_is_simple = count > 0 && is_simple(*first);
    for (Operation const* operation = first; operation != end; ++operation) {
        bool const simple = next_is_simple;
        next_is_simple = operation + 1 != end && is_simple(operation[1]);
        bool const joins = simple && (is_open || operation->own_tail_ports() != 0 || next_is_simple);
        if (joins) {
            add(*operation, joiner);
        } else {
            if (is_open)
                joiner.flush();
            operations.push_back(*operation);
        }
        is_open = joins;
    }
    joiner.flush();
    return operations;
}

void return_tails(std::vector<Operation>& operations) {
    for (std::size_t i = 0; i + 1 < operations.size(); ++i) {
        Operation& operation = operations[i];
        Operation& next = operations[i + 1];
        bool const both_iterate =
            operation.kind() == Operation::Kind::iterate && next.kind() == Operation::Kind::iterate;
        if (!both_iterate || operation.own_tail_ports() == 0 || operation.own_tail_ports() != next.ports() ||
            operation.tail_gap() != 0 || next.gap() != 0 || next.count() == Operation::longest_count)
            continue;
        operation = Operation(Operation::Kind::iterate, operation.ports(), operation.gap(), operation.count());
        next.add(1);
    }
}

}  // namespace dataflow::replay
