#include "dataflow/phrases/phrase.hpp"

#include <algorithm>
#include <array>

namespace dataflow::timing {

namespace {
using Kind = Operation::Kind;
constexpr unsigned most_driver_operations = 16;
constexpr std::uint32_t longest_part = 8 * Operation::longest_mix;
static_assert(Phrase::most_iterations <= Group::lane_mask / (2 * most_driver_operations), "for sums of accesses");

/// Ends with iterations that access nothing: no mix.
bool ends_silent(Operation const& operation) {
    return (operation.own_tail_ports() != 0 ? operation.tail_gap() : operation.gap()) != 0;
}

/// Iterations with or without a silent one behind each, which a mix can say.
bool can_mix(Operation const& operation) {
    return operation.kind() == Kind::mixed || (operation.kind() == Kind::iterate && operation.ports() != 0 &&
                                               operation.gap() <= 1 && operation.tail_ports() == 0);
}
std::uint32_t mixable(Operation const& operation) {
    return operation.kind() == Kind::mixed ? operation.length() : operation.count();
}
/// How often an operation of the driver accesses each anchor.
Group::Lanes accesses_of(Operation const& operation, Group const& group) {
    Kind const kind = operation.kind();
    Group::Lanes const at = group.followers_at(operation.ports());
    if (kind != Kind::iterate && kind != Kind::flanked)
        return at;
    return at * operation.count() +
           (group.followers_at(operation.own_tail_ports()) << (kind == Kind::flanked ? 1U : 0U));
}

/// At least as many bits as a mix has.
std::uint64_t gaps_of(Operation const& operation) {
    return operation.kind() == Kind::mixed ? operation.gaps() : std::uint64_t{0} - operation.gap();
}
}  // namespace

Phrase::Reading Phrase::read(Group const& group, std::uint32_t frozen, unsigned most_that_iterate) {
    start();
    Reading const reading = read_driver(group, most_that_iterate);
    return reading == Reading::complete ? read_answers(group, frozen) : reading;
}

Phrase::Reading Phrase::read_piece(Group const& group) {
    start();
    OperationLog& log = group.members().front().process->log();
    if (log.exhausted())
        return Reading::logs_end;
    log.split_iteration();
    Operation const operation = log.front();
    codes_[size_++] = operation.code();
    take_driver(log, 1, group.followers_at(operation.ports()));
    return read_answers(group, 0);
}

void Phrase::start() {
    size_ = 0;
    active_ = 0;
    part_count_ = 0;
}

void Phrase::take_driver(OperationLog& log, std::size_t operations, Group::Lanes due) {
    due_ = due;
    take(0, log, operations, 0);
}

/// Of all followers to what the driver does.
Phrase::Reading Phrase::read_answers(Group const& group, std::uint32_t frozen) {
    Reading reading = Reading::complete;
    Group::Lanes due = due_;
    for (unsigned m = 1; due != 0 && reading == Reading::complete; ++m, due >>= Group::lane_bits) {
        auto const accesses = static_cast<std::uint32_t>(due & Group::lane_mask);
        if (accesses == 0 || ((frozen >> m) & 1U) != 0)
            continue;
        OperationLog& log = group.members()[m].process->log();
        if (!read_part(log, group.members()[m], m, accesses))
            reading = read_follower(group, m, accesses);
    }
    return reading;
}

/// Silent iterations, then accesses of the loop up to the next silence at most; or what is between two loops, up to the
/// first step that more than one follower answers.
[[gnu::always_inline]] inline Phrase::Reading Phrase::read_driver(Group const& group, unsigned most_that_iterate) {
    OperationLog& log = group.members().front().process->log();
    if (!log.exhausted() && log.whole_front().kind() == Kind::mixed)
        log.front();  // a run of equal iterations is split off
    std::size_t const most = std::min<std::size_t>(log.pending(), most_driver_operations);
    Operation const* const operations = log.begin();
    Operation::Code const outer =
        Operation::at_ports(static_cast<Ports::Number>(~group.members().front().inner_ports & (Ports::numbers - 1U)));
    std::size_t i = 0;
    bool foreign = false;
    unsigned iterated = 0;  // operations, with accesses
    bool ended = false;
    Group::Lanes due = 0;
    for (; i < most && !ended; ++i) {
        Operation const operation = operations[i];
        Kind const kind = operation.kind();
        foreign = kind == Kind::stamp || kind == Kind::mixed || (operation.code() & outer) != 0;
        bool const iterates = (kind == Kind::iterate || kind == Kind::flanked) && operation.ports() != 0;
        if (foreign || (iterated > 0 && !iterates))
            break;
        codes_[size_++] = operation.code();
        if (iterates && operation.count() > most_iterations)
            return Reading::foreign;
        Group::Lanes const at = accesses_of(operation, group);
        due += at;
        iterated += iterates ? 1U : 0U;
        ended = iterates ? iterated == most_that_iterate || ends_silent(operation) : (at & (at - 1)) != 0;
    }
    if (i == 0)
        return foreign ? Reading::foreign : Reading::logs_end;
    take_driver(log, i, due);
    return Reading::complete;
}

Phrase::Next Phrase::next_of(Group::Member const& member, std::size_t from) {
    OperationLog const& log = member.process->log();
    if (from >= log.pending())
        return {};
    Operation const& operation = log.begin()[from];
    auto const ports = static_cast<Ports::Number>(operation.ports() & ~member.fed_ports);
    bool const is_fed = member.fed_ports == 0 || member.fed_iterations() > 0;
    bool const inside = is_fed && (ports & ~member.inner_ports) == 0;
    return {inside ? ports : Ports::Number{0}, true};
}

/// As many of a follower's operations as the driver's accesses of its anchor ask for, and those after them up to its
/// next access of the anchor.
Phrase::Reading Phrase::read_follower(Group const& group, unsigned m, std::uint32_t due) {
    Group::Member const& member = group.members()[m];
    OperationLog& log = member.process->log();
    std::size_t const pending = log.pending();
    auto const anchor = static_cast<Ports::Number>(1U << member.anchor_port);
    unsigned const marker_at = size_;
    mark(m, 0, false);
    std::uint32_t part = 0;
    std::size_t i = 0;
    bool foreign = false;
    Operation const* const operations = log.begin();
    for (; i < pending && part == 0; ++i) {
        Operation operation = operations[i];
        Kind const kind = operation.kind();
        bool const anchored = operation.is_at(anchor);
        if (anchored && due == 0)
            break;
        foreign = kind == Kind::stamp || kind == Kind::flanked || (operation.all_ports() & ~member.inner_ports) != 0;
        if (foreign)
            break;
        if (anchored && kind == Kind::step) {
            --due;
        } else if (anchored) {
            std::uint32_t const offered = kind == Kind::mixed ? operation.length() : operation.count();
            std::uint32_t const all = offered + (operation.tail_ports() != 0 ? 1 : 0);
            if (due < all) {
                part = std::min(due, offered);
                operation = operation.first(part);
            }
            due -= std::min(due, all);
        }
        if (!put(operation))
            return Reading::foreign;
    }
    i -= part > 0 ? 1 : 0;
    // A writer is ahead: it may have nothing more to write, and is out of the game then. A reader must follow.
    bool const frozen = foreign && member.writes_anchor;
    if (foreign && !frozen)
        return Reading::foreign;
    if (i == pending && (due > 0 || member.writes_anchor))
        return Reading::logs_end;
    Next next = part > 0 ? next_in(operations[i], part) : next_of(member, i);
    if (!next.known && log_ends_ != nullptr)
        next.ports = log_ends_[m];
    codes_[marker_at] |= (Code{next.ports} << 8) | (frozen ? 1U : 0U);
    take(m, log, i, part);
    return Reading::complete;
}

/// The usual case: the log goes on with enough iterations of one kind of access, and more. Put as mixes of equal
/// length, whatever operations they come from, so that equal answers are equal codes.
bool Phrase::read_part(OperationLog& log, Group::Member const& follower, unsigned member, std::uint32_t due) {
    std::size_t const pending = log.pending();
    Operation const* const operations = log.begin();
    if (due > longest_part || size_ + longest_part / Operation::longest_mix >= most_codes || pending == 0)
        return false;
    unsigned const first = size_;
    Ports::Number const ports = operations[0].ports();
    if ((ports & ~follower.inner_ports) != 0)
        return false;
    if (read_short_part(log, member, due))
        return true;
    std::uint64_t gaps = 0;
    std::uint32_t length = 0;
    for (std::size_t i = 0; i < pending; ++i) {
        Operation const operation = operations[i];
        bool const is_mix = operation.kind() == Kind::mixed;
        if (operation.ports() != ports || !can_mix(operation))
            break;
        std::uint32_t const offered = mixable(operation);
        std::uint32_t const taken = std::min(offered, due);
        std::uint64_t bits = gaps_of(operation);
        due -= taken;
        for (std::uint32_t left = taken; left > 0;) {
            std::uint32_t const now = std::min(left, Operation::longest_mix - length);
            gaps |= (bits & ((std::uint64_t{1} << now) - 1)) << length;
            bits = is_mix ? bits >> now : bits;
            left -= now;
            length += now;
            if (length == Operation::longest_mix) {
                put_part(ports, length, gaps, member);
                length = 0;
                gaps = 0;
            }
        }
        if (taken == offered)
            continue;
        if (length > 0)
            put_part(ports, length, gaps, member);
        take(member, log, i, taken);
        return true;
    }
    size_ = first;
    return false;
}

/// One mix, from one operation or two: nearly always.
inline bool Phrase::read_short_part(OperationLog& log, unsigned member, std::uint32_t due) {
    Operation const* const operations = log.begin();
    Operation const front = operations[0];
    if (due > Operation::longest_mix || !can_mix(front))
        return false;
    std::uint32_t taken = mixable(front);
    std::uint64_t gaps = gaps_of(front);
    std::size_t whole = 0;
    std::uint32_t part = due;
    if (taken <= due) {
        if (log.pending() < 2)
            return false;
        Operation const second = operations[1];
        if (second.ports() != front.ports() || !can_mix(second) || mixable(second) <= due - taken)
            return false;
        gaps = (gaps & ((std::uint64_t{1} << taken) - 1)) | (gaps_of(second) << taken);
        whole = 1;
        part = due - taken;
    }
    put_part(front.ports(), due, gaps & ((std::uint64_t{1} << due) - 1), member);
    take(member, log, whole, part);
    return true;
}

void Phrase::put_part(Ports::Number ports, std::uint32_t length, std::uint64_t gaps, unsigned member) {
    codes_[size_++] =
        Operation::mix(ports, length, static_cast<std::uint32_t>(gaps)).code() | (Code{16U + member} << part_at);
}

void Phrase::assign(Code const* codes, unsigned size, std::uint32_t active) {
    std::copy(codes, codes + size, codes_.begin());
    size_ = size;
    active_ = active;
    part_count_ = 0;
}

/// Says nothing besides what it can mean, and of ports in the group only.
bool Phrase::is_well_formed(Code code, Group const& group) {
    auto const is_inside = [&group](unsigned member, Ports::Number ports) {
        return member > 0 && member < group.members().size() && (ports & ~group.members()[member].inner_ports) == 0;
    };
    if (is_part(code))
        return operation_of_part(code).is_well_formed() &&
               is_inside(member_of_part(code), operation_of_part(code).ports());
    if (!is_marker(code))
        return Operation(code).is_well_formed();
    constexpr Code known = marker | (Code{0xFF} << 16) | (Code{0xFF} << 8);
    return (code & ~known) == 0 && is_inside(marked_member(code), marked_ports(code));
}

bool Phrase::is_readable(Code const* codes, std::size_t size, Group const& group) {
    if (size == 0 || size > longest ||
        !std::all_of(codes, codes + size, [&group](Code code) { return is_well_formed(code, group); }))
        return false;
    std::array<Ports::Number, Lead::most_members> next_ports{};
    for (Group::Member const& member : group.members())
        member.process->log().clear();
    write(codes, static_cast<unsigned>(size), group,
          [&next_ports](unsigned member, Ports::Number ports, bool /*frozen*/) { next_ports[member] = ports; });
    std::uint32_t parts = 0;
    for (std::size_t i = 0; i < size; ++i)
        parts |= is_part(codes[i]) ? 1U << member_of_part(codes[i]) : 0;
    for (unsigned m = 0; m < group.members().size(); ++m)
        if (((parts >> m) & 1U) != 0)  // it has more
            group.members()[m].process->log().append(Operation(Kind::iterate, next_ports[m], 0, 1));
    Phrase phrase;
    phrase.set_log_ends(next_ports.data());
    bool const read = phrase.read(group, group.suppliers(), most_in_recording) == Reading::complete;
    for (Group::Member const& member : group.members())
        member.process->log().clear();
    return read && phrase.size() == size && std::equal(codes, codes + size, phrase.codes());
}

void Phrase::recall(Code const* codes, unsigned size, Group const& group) {
    std::uint32_t active = 1;
    Group::Lanes due = 0;
    each(
        codes, size,
        [&](unsigned member, Operation const& operation) { due += member == 0 ? accesses_of(operation, group) : 0; },
        [&active](unsigned member, Ports::Number /*next_ports*/, bool /*frozen*/) { active |= 1U << member; });
    assign(codes, size, active);
    due_ = due;
}

void Phrase::consume() {
    for (unsigned i = 0; i < part_count_; ++i)
        parts_[i].log->consume(parts_[i].whole, parts_[i].part);
}

}  // namespace dataflow::timing
