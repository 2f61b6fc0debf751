#include "timing/phrase.hpp"

#include <algorithm>

namespace faster::timing {

namespace {
using Kind = Operation::Kind;
constexpr unsigned most_driver_operations = 8;

/// Ends with iterations that access nothing.
bool ends_silent(Operation const& operation) {
    return operation.tail_ports != 0 ? operation.tail_gap > 0 : operation.gap > 0;
}
}  // namespace

Operation Phrase::operation_of(Code code) {
    Operation operation;
    operation.kind = static_cast<Kind>(code >> 61);
    operation.ports = static_cast<std::uint8_t>(code >> 53);
    if (operation.kind == Kind::mixed) {
        operation.set_mix(static_cast<unsigned>(code >> 45) & 0xFFU, static_cast<std::uint32_t>(code));
        return operation;
    }
    operation.tail_ports = static_cast<std::uint8_t>(code >> 45);
    operation.gap = (code >> 33) & most_gap;
    operation.tail_gap = (code >> 21) & most_gap;
    operation.count = code & most_count;
    return operation;
}

std::uint32_t Phrase::entered(Code const* codes, unsigned size) {
    std::uint32_t members = 0;
    unsigned member = 0;
    for (unsigned i = 0; i < size; ++i) {
        if (is_marker(codes[i]))
            member = marked_member(codes[i]);
        else if (static_cast<Kind>(codes[i] >> 61) == Kind::enter)
            members |= 1U << member;
    }
    return members;
}

Phrase::Reading Phrase::read(Group const& group, std::uint32_t frozen) {
    size_ = 0;
    active_ = 0;
    part_count_ = 0;
    due_.fill(0);
    Reading const driver = read_driver(group);
    if (driver != Reading::complete)
        return driver;
    for (unsigned m = 1; m < group.members().size(); ++m) {
        if (due_[m] == 0 || ((frozen >> m) & 1U) != 0)
            continue;
        Reading const follower = read_follower(group, m);
        if (follower != Reading::complete)
            return follower;
    }
    return Reading::complete;
}

/// Silent iterations, then accesses of the loop up to the next silence; or what is between two loops, up to the first
/// step that writes.
Phrase::Reading Phrase::read_driver(Group const& group) {
    Group::Member const& driver = group.members().front();
    OperationLog& log = driver.process->log();
    std::size_t const pending = log.pending();
    std::size_t i = 0;
    bool foreign = false;
    bool iterated = false;  // with accesses
    bool ended = false;
    mark(0, 0, false);
    for (; i < pending && i < most_driver_operations && !ended; ++i) {
        Operation const& operation = log.at(i);
        bool const iterates = operation.accesses() && operation.kind == Kind::iterate;
        foreign = operation.kind == Kind::stamp || operation.kind == Kind::mixed ||
                  ((operation.ports | operation.tail_ports) & ~driver.inner_ports) != 0;
        if (foreign || (iterated && !iterates))
            break;
        if (!put(operation))
            return Reading::foreign;
        count_due(group, operation);
        iterated = iterated || iterates;
        ended = iterates ? ends_silent(operation) : operation.ports != 0 && writes_any(*driver.process, operation.ports);
    }
    if (i == 0)
        return foreign ? Reading::foreign : Reading::logs_end;
    parts_[part_count_++] = {&log, i, 0};
    active_ |= 1U;
    return Reading::complete;
}

/// How often the driver accesses each follower's anchor.
void Phrase::count_due(Group const& group, Operation const& operation) {
    if (!operation.accesses())
        return;
    std::uint32_t const times = operation.kind == Kind::iterate ? operation.count : 1;
    for (unsigned m = 1; m < group.members().size(); ++m) {
        std::uint8_t const port = group.members()[m].driver_port;
        due_[m] += (operation.ports & port) != 0 ? times : 0;
        due_[m] += (operation.tail_ports & port) != 0 ? 1 : 0;
    }
}

Phrase::Next Phrase::next_of(Group::Member const& member, std::size_t from) {
    OperationLog const& log = member.process->log();
    if (from >= log.pending())
        return {};
    Operation const& operation = log.at(from);
    bool const inside = operation.accesses() && (operation.ports & ~member.inner_ports) == 0;
    return {inside ? operation.ports : std::uint8_t{0}, true};
}

/// As many of a follower's operations as the driver's accesses of its anchor ask for, and those after them up to its
/// next access of the anchor.
Phrase::Reading Phrase::read_follower(Group const& group, unsigned m) {
    Group::Member const& member = group.members()[m];
    OperationLog& log = member.process->log();
    std::size_t const pending = log.pending();
    auto const anchor = static_cast<std::uint8_t>(1U << member.anchor_port);
    unsigned const marker_at = size_;
    mark(m, 0, false);
    std::uint32_t due = due_[m];
    std::uint32_t part = 0;
    std::size_t i = 0;
    bool foreign = false;
    Mix mix(*this);
    for (; i < pending; ++i) {
        Operation const& operation = log.at(i);
        bool const anchored = (operation.ports & anchor) != 0;
        if (anchored && due == 0)
            break;
        foreign = operation.kind == Kind::stamp || ((operation.ports | operation.tail_ports) & ~member.inner_ports) != 0;
        if (foreign)
            break;
        if (anchored && operation.kind != Kind::step) {
            std::uint32_t const offered = operation.kind == Kind::mixed ? operation.length() : operation.count;
            std::uint32_t const taken = std::min(due, offered);
            bool const with_tail = operation.tail_ports != 0 && taken < due;
            due -= taken + (with_tail ? 1 : 0);
            if (!(with_tail ? mix.flush() && put(operation) : mix.add(operation, taken)))
                return Reading::foreign;
            if (taken < offered || (operation.tail_ports != 0 && !with_tail)) {
                part = taken;
                break;
            }
            continue;
        }
        due -= anchored ? 1 : 0;
        if (!mix.flush() || !put(operation))
            return Reading::foreign;
    }
    if (!mix.flush())
        return Reading::foreign;
    // A writer is ahead: it may have nothing more to write, and is out of the game then. A reader must follow.
    bool const frozen = foreign && member.writes_anchor;
    if (foreign && !frozen)
        return Reading::foreign;
    if (i == pending && (due > 0 || member.writes_anchor))
        return Reading::logs_end;
    Next const next = part > 0 ? next_in(log.at(i), part) : next_of(member, i);
    codes_[marker_at] |= (Code{next.ports} << 8) | (frozen ? 1U : 0U);
    parts_[part_count_++] = {&log, i, part};
    active_ |= 1U << m;
    return Reading::complete;
}

bool Phrase::Mix::add(Operation const& operation, std::uint32_t count) {
    bool const is_mix = operation.kind == Kind::mixed;
    if ((length_ > 0 && operation.ports != ports_) || (!is_mix && (operation.gap > 1 || count > Operation::longest_mix))) {
        Operation taken = operation;
        taken.tail_ports = 0;
        taken.tail_gap = 0;
        if (!is_mix)
            taken.count = count;
        else
            taken.set_mix(count, operation.gaps() & Operation::gap_bits(1, count));
        return flush() && phrase_.put(taken);
    }
    ports_ = operation.ports;
    std::uint32_t const all = Operation::gap_bits(1, count);
    std::uint64_t const gaps = is_mix ? operation.gaps() & all : operation.gap == 0 ? 0 : all;
    std::uint64_t const both = gaps_ | (gaps << length_);
    unsigned const length = length_ + count;
    gaps_ = static_cast<std::uint32_t>(both);
    length_ = std::min(length, Operation::longest_mix);
    if (length <= Operation::longest_mix)
        return true;
    if (!flush())
        return false;
    gaps_ = static_cast<std::uint32_t>(both >> Operation::longest_mix);
    length_ = length - Operation::longest_mix;
    return true;
}

bool Phrase::Mix::flush() {
    if (length_ == 0)
        return true;
    if (phrase_.size_ >= most_codes)
        return false;
    phrase_.codes_[phrase_.size_++] = code_of_mix(ports_, length_, gaps_);
    length_ = 0;
    gaps_ = 0;
    return true;
}

void Phrase::consume() {
    for (unsigned i = 0; i < part_count_; ++i)
        parts_[i].log->consume(parts_[i].whole, parts_[i].part);
}

}  // namespace faster::timing
