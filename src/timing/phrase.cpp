#include "timing/phrase.hpp"

#include <algorithm>

namespace faster::timing {

namespace {
using Kind = Operation::Kind;
constexpr unsigned most_driver_operations = 16;
constexpr std::uint32_t most_iterations = Group::lane_mask / (2 * most_driver_operations);

/// Ends with iterations that access nothing.
bool ends_silent(Operation const& operation) {
    return operation.tail_ports() != 0 ? operation.tail_gap() > 0 : operation.gap() > 0;
}
}  // namespace

std::uint32_t Phrase::entered(Code const* codes, unsigned size) {
    std::uint32_t members = 0;
    unsigned member = 0;
    for (unsigned i = 0; i < size; ++i) {
        if (is_marker(codes[i]))
            member = marked_member(codes[i]);
        else if (Operation(codes[i]).kind() == Kind::enter)
            members |= 1U << member;
    }
    return members;
}

Phrase::Reading Phrase::read(Group const& group, std::uint32_t frozen) {
    size_ = 0;
    active_ = 0;
    part_count_ = 0;
    Reading reading = read_driver(group);
    Group::Lanes due = due_;
    for (unsigned m = 1; due != 0 && reading == Reading::complete; ++m, due >>= Group::lane_bits) {
        auto const accesses = static_cast<std::uint32_t>(due & Group::lane_mask);
        if (accesses == 0 || ((frozen >> m) & 1U) != 0)
            continue;
        OperationLog& log = group.members()[m].process->log();
        if (!read_part(log, m, accesses))
            reading = read_follower(group, m, accesses);
    }
    return reading;
}

/// Silent iterations, then accesses of the loop up to the next silence; or what is between two loops, up to the first
/// step that more than one follower answers.
Phrase::Reading Phrase::read_driver(Group const& group) {
    Group::Member const& driver = group.members().front();
    OperationLog& log = driver.process->log();
    std::size_t const most = std::min<std::size_t>(log.pending(), most_driver_operations);
    Operation const* const operations = log.begin();
    std::size_t i = 0;
    bool foreign = false;
    bool iterated = false;  // with accesses
    bool ended = false;
    Group::Lanes due = 0;
    for (; i < most && !ended; ++i) {
        Operation const operation = operations[i];
        Kind const kind = operation.kind();
        bool const iterates = kind == Kind::iterate && operation.ports() != 0;
        foreign = kind == Kind::stamp || kind == Kind::mixed || (operation.all_ports() & ~driver.inner_ports) != 0;
        if (foreign || (iterated && !iterates))
            break;
        codes_[size_++] = operation.code();
        if (iterates) {
            if (operation.count() > most_iterations)
                return Reading::foreign;
            due +=
                group.followers_at(operation.ports()) * operation.count() + group.followers_at(operation.tail_ports());
            iterated = true;
            ended = ends_silent(operation);
        } else if (operation.ports() != 0) {
            Group::Lanes const at = group.followers_at(operation.ports());
            due += at;
            ended = (at & (at - 1)) != 0;
        }
    }
    if (i == 0)
        return foreign ? Reading::foreign : Reading::logs_end;
    due_ = due;
    parts_[part_count_++] = {&log, i, 0};
    active_ |= 1U;
    return Reading::complete;
}

Phrase::Next Phrase::next_of(Group::Member const& member, std::size_t from) {
    OperationLog const& log = member.process->log();
    if (from >= log.pending())
        return {};
    Operation const& operation = log.begin()[from];
    bool const inside = (operation.ports() & ~member.inner_ports) == 0;
    return {inside ? operation.ports() : std::uint8_t{0}, true};
}

/// As many of a follower's operations as the driver's accesses of its anchor ask for, and those after them up to its
/// next access of the anchor.
Phrase::Reading Phrase::read_follower(Group const& group, unsigned m, std::uint32_t due) {
    Group::Member const& member = group.members()[m];
    OperationLog& log = member.process->log();
    std::size_t const pending = log.pending();
    auto const anchor = static_cast<std::uint8_t>(1U << member.anchor_port);
    unsigned const marker_at = size_;
    mark(m, 0, false);
    std::uint32_t part = 0;
    std::size_t i = 0;
    bool foreign = false;
    Mix mix(*this);
    Operation const* const operations = log.begin();
    for (; i < pending; ++i) {
        Operation const operation = operations[i];
        Kind const kind = operation.kind();
        bool const anchored = (operation.ports() & anchor) != 0;
        if (anchored && due == 0)
            break;
        foreign = kind == Kind::stamp || (operation.all_ports() & ~member.inner_ports) != 0;
        if (foreign)
            break;
        if (!anchored || kind == Kind::step) {
            due -= anchored ? 1 : 0;
            if (!mix.flush() || !put(operation))
                return Reading::foreign;
            continue;
        }
        std::uint32_t const offered = kind == Kind::mixed ? operation.length() : operation.count();
        std::uint32_t const taken = std::min(due, offered);
        bool const has_tail = operation.tail_ports() != 0;
        bool const with_tail = has_tail && taken < due;
        due -= taken + (with_tail ? 1 : 0);
        if (!(with_tail ? mix.flush() && put(operation) : mix.add(operation, taken)))
            return Reading::foreign;
        if (taken < offered || has_tail != with_tail) {
            part = taken;
            break;
        }
    }
    if (!mix.flush())
        return Reading::foreign;
    // A writer is ahead: it may have nothing more to write, and is out of the game then. A reader must follow.
    bool const frozen = foreign && member.writes_anchor;
    if (foreign && !frozen)
        return Reading::foreign;
    if (i == pending && (due > 0 || member.writes_anchor))
        return Reading::logs_end;
    Next const next = part > 0 ? next_in(operations[i], part) : next_of(member, i);
    codes_[marker_at] |= (Code{next.ports} << 8) | (frozen ? 1U : 0U);
    parts_[part_count_++] = {&log, i, part};
    active_ |= 1U << m;
    return Reading::complete;
}

bool Phrase::Mix::add(Operation const& operation, std::uint32_t count) {
    bool const is_mix = operation.kind() == Kind::mixed;
    bool const fits = is_mix || (operation.gap() <= 1 && count <= Operation::longest_mix);
    if (!fits || (length_ > 0 && operation.ports() != ports_))
        return flush() && phrase_.put(operation.first(count));
    ports_ = operation.ports();
    std::uint64_t const gaps =
        is_mix ? operation.gaps() & Operation::gap_bits(1, count) : Operation::gap_bits(operation.gap(), count);
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
    phrase_.codes_[phrase_.size_++] = Operation::mix(ports_, length_, gaps_).code();
    length_ = 0;
    gaps_ = 0;
    return true;
}

/// The usual case: the log goes on with enough iterations of one kind of access, and more.
bool Phrase::read_part(OperationLog& log, unsigned member, std::uint32_t due) {
    std::size_t const pending = log.pending();
    Operation const* const operations = log.begin();
    if (due > Operation::longest_mix || size_ >= most_codes || pending == 0)
        return false;
    std::uint8_t const ports = operations[0].ports();
    std::uint64_t gaps = 0;
    std::uint32_t length = 0;
    for (std::size_t i = 0; i < pending; ++i) {
        Operation const operation = operations[i];
        bool const is_mix = operation.kind() == Kind::mixed;
        bool const is_run = operation.kind() == Kind::iterate && operation.gap() <= 1 && operation.tail_ports() == 0;
        if (operation.ports() != ports || ports == 0 || !(is_mix || is_run))
            return false;
        std::uint32_t const offered = is_mix ? operation.length() : operation.count();
        std::uint32_t const taken = std::min(offered, due - length);
        std::uint64_t const bits = is_mix ? operation.gaps() : std::uint64_t{0} - operation.gap();
        gaps |= (bits & ((std::uint64_t{1} << taken) - 1)) << length;
        length += taken;
        if (taken == offered)
            continue;
        codes_[size_++] =
            Operation::mix(ports, due, static_cast<std::uint32_t>(gaps)).code() | (Code{16U + member} << part_at);
        parts_[part_count_++] = {&log, i, taken};
        active_ |= 1U << member;
        return true;
    }
    return false;
}

void Phrase::consume() {
    for (unsigned i = 0; i < part_count_; ++i)
        parts_[i].log->consume(parts_[i].whole, parts_[i].part);
}

}  // namespace faster::timing
