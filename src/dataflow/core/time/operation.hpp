#pragma once
#include <algorithm>
#include <cstdint>

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

    /// Of a flanked one, `count` at least 2: the first iteration with the one behind it.
    Operation head() const {
        Operation head(Kind::iterate, ports(), 0, 1);
        head.add_tail(tail_ports(), 0);
        return head;
    }
    Operation rest() const {  ///< all others, with the tail
        Operation rest(Kind::iterate, ports(), 0, count() - 1);
        rest.add_tail(tail_ports(), tail_gap());
        return rest;
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
    /// Of a step to reach.
    std::uint32_t step() const { return count() >> 1U; }
    bool stops_before() const { return (count() & 1U) != 0; }
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

}  // namespace dataflow::timing
