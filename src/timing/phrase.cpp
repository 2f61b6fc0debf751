#include "timing/phrase.hpp"

#include <algorithm>

namespace faster::timing {

namespace {
using Kind = Operation::Kind;
constexpr std::uint32_t most_count = 0xFFFF;
constexpr std::uint16_t most_gap = 31;
constexpr unsigned most_driver_operations = 10;

bool accesses(Operation const& operation) {
    return (operation.kind == Kind::step || operation.kind == Kind::iterate) && operation.ports != 0;
}
}  // namespace

bool Phrase::put(Operation const& operation, std::uint32_t count) {
    if (size_ >= most_codes || count > most_count || operation.gap > most_gap)
        return false;
    codes_[size_++] = (static_cast<std::uint32_t>(operation.kind) << 29) | (std::uint32_t{operation.ports} << 21) |
                      (std::uint32_t{operation.gap} << 16) | count;
    return true;
}

void Phrase::append(std::uint32_t code, OperationLog& log) {
    std::uint32_t const count = code & most_count;
    auto const ports = static_cast<std::uint8_t>(code >> 21);
    switch (static_cast<Kind>(code >> 29)) {
        case Kind::wait:
            log.wait(count);
            break;
        case Kind::step:
            log.step(ports, count);
            break;
        case Kind::enter:
            log.enter(count);
            break;
        case Kind::iterate:
            log.iterate(ports, static_cast<std::uint16_t>((code >> 16) & most_gap), count);
            break;
        case Kind::leave:
            log.leave();
            break;
        case Kind::stamp:
            break;  // never part of a phrase
    }
}

std::uint32_t Phrase::entered(std::uint32_t const* codes, unsigned size) {
    std::uint32_t members = 0;
    unsigned member = 0;
    for (unsigned i = 0; i < size; ++i) {
        if (is_marker(codes[i]))
            member = marked_member(codes[i]);
        else if (static_cast<Kind>(codes[i] >> 29) == Kind::enter)
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
    std::uint32_t part = 0;
    bool accessed = false;
    bool foreign = false;
    mark(0, 0, false);
    for (; i < pending && i < most_driver_operations && part == 0; ++i) {
        Operation const& operation = log.at(i);
        bool const access = accesses(operation);
        foreign = operation.kind == Kind::stamp || (operation.ports & ~driver.inner_ports) != 0;
        if (foreign || (accessed && !(access && operation.kind == Kind::iterate)))
            break;
        std::uint32_t count = operation.count;
        if (operation.kind == Kind::iterate && count > most_count)
            count = part = most_count;
        if (!put(operation, count))
            return Reading::foreign;
        if (!access)
            continue;
        for (unsigned m = 1; m < group.members().size(); ++m)
            if ((group.members()[m].driver_port & operation.ports) != 0)
                due_[m] += operation.kind == Kind::iterate ? count : 1;
        if (operation.kind == Kind::iterate) {
            accessed = true;
        } else if (std::uint32_t const last = operation.ports; driver.process->writes(
                       31U - static_cast<unsigned>(__builtin_clz(last)))) {
            ++i;
            break;
        }
    }
    std::size_t const whole = part > 0 ? i - 1 : i;
    if (i == 0)
        return foreign ? Reading::foreign : Reading::logs_end;
    parts_[part_count_++] = {&log, whole, part};
    active_ |= 1U;
    return Reading::complete;
}

Phrase::Next Phrase::next_of(Group::Member const& member, std::size_t from) {
    OperationLog const& log = member.process->log();
    if (from >= log.pending())
        return {};
    Operation const& operation = log.at(from);
    bool const inside = accesses(operation) && (operation.ports & ~member.inner_ports) == 0;
    return {inside ? operation.ports : std::uint8_t{0}, true};
}

/// As many of a follower's operations as the driver's accesses of its anchor ask for, and those after them up to its
/// next access of the anchor.
Phrase::Reading Phrase::read_follower(Group const& group, unsigned m) {
    Group::Member const& member = group.members()[m];
    OperationLog& log = member.process->log();
    std::size_t const pending = log.pending();
    auto const anchor = static_cast<std::uint8_t>(1U << member.anchor_port);
    unsigned const marker = size_;
    mark(m, 0, false);
    std::uint32_t due = due_[m];
    std::uint32_t part = 0;
    std::size_t i = 0;
    bool foreign = false;
    for (; i < pending; ++i) {
        Operation const& operation = log.at(i);
        bool const anchored = (operation.ports & anchor) != 0 && accesses(operation);
        if (anchored && due == 0)
            break;
        foreign = operation.kind == Kind::stamp || (operation.ports & ~member.inner_ports) != 0;
        if (foreign)
            break;
        std::uint32_t count = operation.count;
        if (anchored) {
            std::uint32_t const offered = operation.kind == Kind::iterate ? count : 1;
            std::uint32_t const taken = std::min(offered, due);
            due -= taken;
            if (operation.kind == Kind::iterate)
                count = taken;
            if (taken < offered)
                part = taken;
        }
        if (!put(operation, count))
            return Reading::foreign;
        if (part > 0)
            break;
    }
    // A writer is ahead: it may have nothing more to write, and is out of the game then. A reader must follow.
    bool const frozen = foreign && member.writes_anchor;
    if (foreign && !frozen)
        return Reading::foreign;
    if (i == pending && (due > 0 || member.writes_anchor))
        return Reading::logs_end;
    Next const next = part > 0 ? Next{log.at(i).ports, true} : next_of(member, i);
    codes_[marker] |= (std::uint32_t{next.ports} << 8) | (frozen ? 1U : 0U);
    parts_[part_count_++] = {&log, i, part};
    active_ |= 1U << m;
    return Reading::complete;
}

void Phrase::consume() {
    for (unsigned i = 0; i < part_count_; ++i)
        parts_[i].log->consume(parts_[i].whole, parts_[i].part);
}

}  // namespace faster::timing
