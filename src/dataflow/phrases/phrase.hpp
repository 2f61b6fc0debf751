#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "dataflow/phrases/group.hpp"
#include "dataflow/phrases/print.hpp"

namespace dataflow::timing {

/// The next few operations of a driver, with those by which its followers answer to them: a row of iterations,
/// the steps between two loops. Written as a list of codes, so that equal phrases are equal lists.
class Phrase {
  public:
    using Code = Operation::Code;
    static constexpr unsigned most_codes = 48;  ///< and a mark for each follower
    static constexpr unsigned longest = most_codes + Lead::most_members;
    /// Of iterations that access something, in one operation of the driver.
    static constexpr std::uint32_t most_iterations = Group::lane_mask / 32;

    enum class Reading { complete, logs_end, foreign };

    /// Operations of the driver in a phrase that iterate with accesses, at most. Long phrases are fewer: a run, which
    /// reads each once, takes a tenth less. Short ones are more alike: a recording has few that differ.
    static constexpr unsigned most_in_run = 3, most_in_recording = 1;

    /// Reads the next phrase from the logs. logs_end: some process has not said yet what it does; foreign: the driver
    /// or a follower goes on with something outside the group. `frozen`: bit per member that is out of the game.
    Reading read(Group const& group, std::uint32_t frozen, unsigned most_that_iterate);
    /// Reads the next piece of a phrase that is all there: a single operation of the driver, and of iterations that
    /// access something a single one, with the answers to it.
    Reading read_piece(Group const& group);

    /// Takes the phrase's operations out of the logs.
    void consume();
    /// What each member goes on with where its log ends, if that is known: ports of its next step, or null.
    void set_log_ends(Ports::Number const* next_ports) { log_ends_ = next_ports; }

    /// Becomes a phrase that was read before, with `active` members.
    void assign(Code const* codes, unsigned size, std::uint32_t active);
    /// Becomes a phrase that a group wrote before; all the rest follows from the codes.
    void recall(Code const* codes, unsigned size, Group const& group);
    /// Of the codes, and of a number that goes with them.
    Print print(std::uint64_t number) const;

    Code const* codes() const { return codes_.data(); }
    unsigned size() const { return size_; }
    /// Members that did something, a bit each.
    std::uint32_t active() const { return active_; }
    /// Accesses of each anchor by the driver.
    Group::Lanes due() const { return due_; }
    /// Accesses of the anchor that the supplier writes; 0 without a supplier.
    std::uint32_t due_of_supplier(Group const& group) const {
        if (!group.has_supplier())
            return 0;
        return static_cast<std::uint32_t>(due_ >> (Group::lane_bits * (group.supplier() - 1)) & Group::lane_mask);
    }

    /// Whether read() could have written codes of a recording, wherever they are from, with the supplier left out.
    /// On the logs of a group that is only a workbench.
    static bool is_readable(Code const* codes, std::size_t size, Group const& group);

    /// Visits (member, operation) what coded phrases say, in order, and tells what each follower goes on with, by
    /// visiting (member, ports of its next step; 0: unknown, frozen).
    template <class Do, class GoOn> static void each(Code const* codes, unsigned size, Do visit, GoOn visit_next) {
        unsigned member = 0;  // the driver comes first, unmarked
        for (unsigned i = 0; i < size; ++i) {
            if (is_part(codes[i])) {
                unsigned const follower = member_of_part(codes[i]);
                Operation const operation = operation_of_part(codes[i]);
                visit(follower, operation);
                visit_next(follower, operation.ports(), false);
                continue;
            }
            if (is_marker(codes[i])) {
                member = marked_member(codes[i]);
                visit_next(member, marked_ports(codes[i]), (codes[i] & 1U) != 0);
                continue;
            }
            visit(member, Operation(codes[i]));
        }
    }

    /// Appends the operations to the logs of a group's processes, and tells what each follower goes on with, as each().
    template <class GoOn> static void write(Code const* codes, unsigned size, Group const& group, GoOn visit_next) {
        each(
            codes, size,
            [&group](unsigned member, Operation const& operation) {
                group.members()[member].process->log().append(operation);
            },
            visit_next);
    }

    /// What a process does next, when it goes on from where it is.
    struct Next {
        Ports::Number ports = 0;  ///< of its next step; 0: unknown or outside the group
        bool known = false;       ///< otherwise the log ends here
    };
    static Next next_of(Group::Member const& member, std::size_t from);

  private:
    struct Part {
        OperationLog* log;
        std::size_t whole;
        std::uint32_t part;
    };

    static bool is_well_formed(Code code, Group const& group);
    bool put(Operation const& operation) {
        if (size_ >= most_codes)
            return false;
        codes_[size_++] = operation.code();
        return true;
    }
    void start();
    Reading read_driver(Group const& group, unsigned most_that_iterate);
    void take_driver(OperationLog& log, std::size_t operations, Group::Lanes due);
    Reading read_answers(Group const& group, std::uint32_t frozen);
    static Next next_in(Operation const& operation, std::uint32_t taken) {
        bool const goes_on = operation.kind() == Operation::Kind::mixed || taken < operation.count();
        return {goes_on ? operation.ports() : operation.tail_ports(), true};
    }
    /// Whole operations that a member's log begins with, and a part of the next.
    void take(unsigned member, OperationLog& log, std::size_t whole, std::uint32_t part) {
        parts_[part_count_++] = {&log, whole, part};
        active_ |= 1U << member;
    }
    bool read_part(OperationLog& log, Group::Member const& follower, unsigned member, std::uint32_t due);
    bool read_short_part(OperationLog& log, unsigned member, std::uint32_t due);
    void put_part(Ports::Number ports, std::uint32_t length, std::uint64_t gaps, unsigned member);
    Reading read_follower(Group const& group, unsigned member, std::uint32_t due);
    void mark(unsigned member, Ports::Number next_ports, bool frozen) {
        codes_[size_++] = marker | (Code{member} << 16) | (Code{next_ports} << 8) | (frozen ? 1U : 0U);
    }
    /// A mix of which the follower has more, and all it does are mixes: a code of its own, with the follower's number.
    static constexpr unsigned part_at = 39;
    static bool is_part(Code code) { return (code >> 61) == 6 && ((code >> (part_at + 4)) & 1U) != 0; }
    static unsigned member_of_part(Code code) { return static_cast<unsigned>(code >> part_at) & 0xFU; }
    static Operation operation_of_part(Code code) { return Operation(code & ~(Code{0x1F} << part_at)); }
    static constexpr Code marker = (Code{6} << 61) | (Code{1} << (part_at - 1));
    static bool is_marker(Code code) { return (code >> 61) == 6 && ((code >> (part_at - 1)) & 1U) != 0; }
    static unsigned marked_member(Code code) { return static_cast<unsigned>(code >> 16) & 0xFFU; }
    static Ports::Number marked_ports(Code code) { return static_cast<Ports::Number>((code >> 8) & 0xFFU); }

    std::array<Code, longest> codes_{};
    unsigned size_ = 0;
    std::uint32_t active_ = 0;
    Group::Lanes due_ = 0;
    Ports::Number const* log_ends_ = nullptr;
    std::array<Part, Lead::most_members> parts_{};
    unsigned part_count_ = 0;
};

/// Two codes at a time go into a product of 128 bits, with what came before.
inline Print Phrase::print(std::uint64_t number) const {
    __extension__ using Wide = unsigned __int128;
    std::uint64_t first = number * 0x9E3779B97F4A7C15U;
    std::uint64_t second = 0xC2B2AE3D27D4EB4FU + size_;
    auto const take = [&first, &second](std::uint64_t one, std::uint64_t other) {
        Wide const product = Wide{one ^ first} * (other ^ second);
        std::uint64_t const turned = (first << 32) | (first >> 32);
        first = static_cast<std::uint64_t>(product) + second;
        second = static_cast<std::uint64_t>(product >> 64) ^ turned;
    };
    unsigned i = 0;
    for (; i + 1 < size_; i += 2)
        take(codes_[i], codes_[i + 1]);
    take(i < size_ ? codes_[i] : 0, 0xD6E8FEB86659FD93U);
    return {first ^ (first >> 32), second};
}

}  // namespace dataflow::timing
