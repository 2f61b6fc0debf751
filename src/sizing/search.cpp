#include "sizing/search.hpp"

#include <algorithm>
#include <optional>

#include "common/on_threads.hpp"
#include "sizing/last_that_holds.hpp"
#include "sizing/token_bits.hpp"

namespace faster::sizing {

namespace {

constexpr std::uint64_t first_depth = 64;
constexpr std::uint64_t growth = 512;

bool may_be_shift_register(FifoKind configured) { return configured != FifoKind::memory; }

}  // namespace

FifoFrame::FifoFrame(AcceleratorConfig const& config, CostWeights const& cost_weights) : weights(cost_weights) {
    for (std::size_t i = 0; i < fifo_count; ++i) {
        kinds[i] = config.fifos[i].kind;
        bits[i] = token_bits(static_cast<FifoId>(i), config);
    }
}

/// Until the critical path of a core waits for no room.
void deepen(Choice& choice, std::size_t core, CoreTimes& times) {
    for (bool is_deeper = true; is_deeper;) {
        is_deeper = false;
        for (Cut::Member const& member : times.explain(core, choice).members) {
            FifoChoice& fifo = choice[index_of(member.fifo)];
            if (member.capacity == 0 || fifo.depth == most_depth)
                continue;
            fifo.depth = std::min(most_depth, fifo.depth * growth);
            is_deeper = true;
        }
    }
}

/// No room that no core ever needs.
Choice without_spare_room(Choice const& choice, CoreTimes const& times) {
    Choice smaller = choice;
    for (std::size_t i = 0; i < fifo_count; ++i) {
        std::uint64_t const spare = choice[i].capacity() - times.needed_room(choice, i);
        smaller[i].depth -= std::min(spare, choice[i].depth - 1);
    }
    return smaller;
}

Unbounded unbounded(FifoFrame const& frame, CoreTimes& times, unsigned jobs) {
    Unbounded result;
    for (std::size_t i = 0; i < fifo_count; ++i)
        result.choice[i] = choice_of(frame.kinds[i], first_depth);
    for (std::size_t last = 0; last < times.cores();) {
        deepen(result.choice, last, times);
        result.total_cycles = times.total_cycles(result.choice, jobs);
        if (times.cycles(last, result.choice) == result.total_cycles)
            break;
        last = 0;
        while (times.cycles(last, result.choice) != result.total_cycles)
            ++last;
    }
    result.choice = without_spare_room(result.choice, times);
    return result;
}

Search::Search(FifoFrame const& frame, CoreTimes& times, Unbounded const& unbounded, unsigned jobs,
               std::size_t most_retimings)
    : frame_(frame), times_(times), unbounded_(unbounded), jobs_(std::max(1U, jobs)), most_retimings_(most_retimings) {
    for (std::size_t i = 0; i < fifo_count; ++i) {
        std::uint64_t const tokens = std::min(most_depth, std::max<std::uint64_t>(1, times.tokens()[i]));
        room_[i] = unbounded.choice[i].capacity();
        levels_[i] = levels_of(frame.kinds[i], frame.bits[i], tokens, frame.weights);
    }
}

std::size_t Search::broken_core(Choice const& choice, Cycles bound) {
    if (times_.cores() == 0 || times_.exceeds(strict_core_, choice, bound))
        return times_.cores() == 0 ? 0 : strict_core_;
    std::size_t const core = times_.first_to_exceed(choice, bound, jobs_);
    if (core < times_.cores())
        strict_core_ = core;
    return core;
}

bool Search::is_within(Choice const& choice, Cycles bound) { return broken_core(choice, bound) == times_.cores(); }

double Search::cost_of_choice(Choice const& choice) const {
    return cost_of(sum_of(choice, frame_.bits, frame_.weights), frame_.weights);
}

std::vector<Cut> Search::cuts_against(Cycles bound) const {
    std::vector<Cut> cuts;
    std::copy_if(cuts_.begin(), cuts_.end(), std::back_inserter(cuts),
                 [bound](Cut const& cut) { return cut.total_cycles > bound; });
    return cuts;
}

Found Search::cheapest(Cycles bound) {
    Found found;
    for (;;) {
        auto const choice = cheapest_choice(levels_, cuts_against(bound));
        if (!choice)
            break;
        found.choice = *choice;
        found.least_cost = cost_of_choice(*choice);
        found.is_proven = !learn(*choice, bound);
        if (found.is_proven || times_.retimed_cores() >= most_retimings_)
            break;
    }
    if (!found.is_proven)
        found.choice = descend(bound);
    found.total_cycles = times_.total_cycles(found.choice, jobs_);
    return found;
}

/// Why a choice breaks the bound; false: it does not. The core that broke the last bound is asked first, and why at
/// once.
bool Search::learn(Choice const& choice, Cycles bound) {
    std::optional<Cut> cut;
    if (times_.cores() > 0 && times_.known_to_exceed(strict_core_, choice, bound).value_or(true))
        cut = times_.suspects(strict_core_, choice, bound);
    std::size_t const core = broken_core(choice, bound);
    if (core == times_.cores())
        return false;
    if (!cut || cut->total_cycles <= bound)
        cut = times_.suspects(core, choice, bound);
    for (std::size_t i = 0; i < fifo_count; ++i)
        room_[i] = std::max(room_[i], choice[i].capacity());  // so that the cut rules this choice out
    if (!times_.exceeds(core, corner(*cut), bound))           // the suspects are not all who are to blame
        cut = times_.explain(core, choice);
    cuts_.push_back(widened(*cut, core, bound));
    return true;
}

/// The slowest way to escape a cut: everything that it does not ask for is as quick as can be.
Choice Search::corner(Cut const& cut) const {
    Choice choice;
    for (std::size_t i = 0; i < fifo_count; ++i) {
        std::uint64_t capacity = room_[i];
        bool is_memory = !may_be_shift_register(frame_.kinds[i]);
        for (Cut::Member const& member : cut.members)
            if (index_of(member.fifo) == i) {
                capacity = member.capacity > 0 ? member.capacity : capacity;
                is_memory = is_memory || member.is_slow;
            }
        choice[i] =
            is_memory ? FifoChoice{FifoKind::memory, capacity - 1} : FifoChoice{FifoKind::shift_register, capacity};
    }
    return choice;
}

/// As many choices as can be ruled out with a cut that the bound is broken by.
Cut Search::widened(Cut cut, std::size_t core, Cycles bound) {
    drop_members(cut, core, bound);
    for (std::size_t i = 0; i < cut.members.size(); ++i)
        if (cut.members[i].capacity > 0)
            deepen_member(cut, i, core, bound);
    std::vector<FifoId> members;
    for (Cut::Member const& member : cut.members)
        if (member.capacity > 0)
            members.push_back(member.fifo);
    cut.total_cycles = times_.least_cycles(core, corner(cut));
    bool const is_sure = times_.has_room_but_for(core, corner(cut), members);
    explain_ahead(cut, core, is_sure, bound);
    return is_sure ? cut : times_.explain(core, corner(cut));
}

/// Finds out why a cut's corner takes as long as it does, which may depend on more than the members, and at the same
/// time why the choice does that will be next if it does not, as mostly.
void Search::explain_ahead(Cut const& cut, std::size_t core, bool is_sure, Cycles bound) {
    std::vector<Cut> cuts = cuts_against(bound);
    cuts.push_back(cut);
    std::optional<Choice> const next = jobs_ > 1 && !is_sure ? cheapest_choice(levels_, cuts) : std::nullopt;
    on_threads(next ? 2 : 1, jobs_, [&](std::size_t i) {
        if (i == 1)
            times_.suspects(strict_core_, *next, bound);
        else if (!is_sure)
            times_.explain(core, corner(cut));
    });
}

/// To one member that suffices, or until none can be spared.
void Search::drop_members(Cut& cut, std::size_t core, Cycles bound) {
    auto const breaks = [&](std::vector<Cut::Member> const& members) {
        return times_.exceeds(core, corner({members, 0}), bound);
    };
    for (std::size_t i = 0; i < cut.members.size() && cut.members.size() > 1; i += jobs_) {
        std::size_t const count = std::min<std::size_t>(jobs_, cut.members.size() - i);
        on_threads(count, jobs_, [&](std::size_t k) { breaks({cut.members[i + k]}); });
        for (std::size_t k = 0; k < count && cut.members.size() > 1; ++k)
            if (breaks({cut.members[i + k]}))
                cut.members = {cut.members[i + k]};
    }
    for (std::size_t i = cut.members.size(); i-- > 0 && cut.members.size() > 2;) {
        std::vector<Cut::Member> fewer = cut.members;
        fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
        std::vector<Cut::Member> still_fewer = fewer;  // what is asked next if this breaks the bound
        if (i > 0)
            still_fewer.erase(still_fewer.begin() + static_cast<std::ptrdiff_t>(i - 1));
        on_threads(i > 0 && jobs_ > 1 ? 2 : 1, jobs_,
                   [&](std::size_t k) { k == 0 ? breaks(fewer) : breaks(still_fewer); });
        if (breaks(fewer))
            cut.members = fewer;
    }
}

void Search::deepen_member(Cut& cut, std::size_t member, std::size_t core, Cycles bound) {
    std::size_t const fifo = index_of(cut.members[member].fifo);
    std::vector<std::uint64_t> capacities{cut.members[member].capacity};
    for (Level const& level : levels_[fifo])
        if (level.choice.capacity() > capacities.front() && level.choice.capacity() < room_[fifo])
            capacities.push_back(level.choice.capacity());
    capacities.push_back(room_[fifo]);
    std::sort(capacities.begin(), capacities.end());
    auto const corner_at = [&](std::size_t i) {
        Cut deeper = cut;
        deeper.members[member].capacity = capacities[i];
        return corner(deeper);
    };
    Monotone const breaks{[&](std::size_t i) { return times_.exceeds(core, corner_at(i), bound); },
                          [&](std::size_t i) { return times_.known_to_exceed(core, corner_at(i), bound); }};
    std::size_t const last = last_that_holds(capacities.size(), jobs_, breaks);
    cut.members[member].capacity = last + 1 < capacities.size() ? capacities[last] : 0;  // however deep: it is too slow
}

/// From unbounded FIFOs down, one after the other, until none can be had for less.
Choice Search::descend(Cycles bound) {
    Choice choice = unbounded_.choice;
    for (bool is_cheaper = true; is_cheaper;) {
        is_cheaper = false;
        for (std::size_t i = 0; i < fifo_count; ++i)
            is_cheaper = cheapen(choice, i, bound) || is_cheaper;
    }
    return choice;
}

bool Search::cheapen(Choice& choice, std::size_t fifo, Cycles bound) {
    double const cost = cost_of(primitives_of(choice[fifo].kind, choice[fifo].depth, frame_.bits[fifo], frame_.weights),
                                frame_.weights);
    for (FifoKind const kind : {FifoKind::shift_register, FifoKind::memory}) {
        std::vector<Level> levels;
        std::copy_if(levels_[fifo].rbegin(), levels_[fifo].rend(), std::back_inserter(levels),
                     [&](Level const& level) { return level.choice.kind == kind && level.cost < cost; });
        Choice cheaper = choice;
        auto const is_within_at = [&](std::size_t i) {
            cheaper[fifo] = levels[i].choice;
            return is_within(cheaper, bound);
        };
        if (levels.empty() || !is_within_at(0))
            continue;
        Monotone const fits{is_within_at, [](std::size_t) { return std::nullopt; }};
        choice[fifo] = levels[last_that_holds(levels.size(), 1, fits)].choice;
        return true;
    }
    return false;
}

Found Search::shallowest(Found found, Cycles bound) {
    std::vector<std::size_t> cores{strict_core_};
    while (times_.cores() > 0) {
        Choice const choice = without_spare_tokens(found.choice, bound, cores);
        std::size_t const broken = broken_core(choice, bound);
        if (broken == times_.cores()) {
            found.choice = choice;
            found.total_cycles = times_.total_cycles(choice, jobs_);
            return found;
        }
        cores.push_back(broken);
    }
    return found;
}

std::optional<bool> Search::known_to_fit(Choice const& choice, Cycles bound,
                                         std::vector<std::size_t> const& cores) const {
    bool is_known = true;
    for (std::size_t const core : cores) {
        std::optional<bool> const exceeds = times_.known_to_exceed(core, choice, bound);
        if (exceeds.value_or(false))
            return false;
        is_known = is_known && exceeds.has_value();
    }
    return is_known ? std::optional<bool>(true) : std::nullopt;
}

/// Looks at some cores only.
Choice Search::without_spare_tokens(Choice choice, Cycles bound, std::vector<std::size_t> const& cores) {
    for (std::size_t i = 0; i < fifo_count; ++i) {
        std::uint64_t const deepest = choice[i].depth;
        std::uint64_t shallowest = deepest;
        while (shallowest > 1 && choice_of(frame_.kinds[i], shallowest - 1).kind == choice[i].kind)
            --shallowest;
        auto const with_less = [&, before = choice](std::size_t less) {
            Choice shallower = before;
            shallower[i].depth = deepest - less;
            return shallower;
        };
        Monotone const fits{[&](std::size_t less) {
                                return std::none_of(cores.begin(), cores.end(), [&](std::size_t core) {
                                    return times_.exceeds(core, with_less(less), bound);
                                });
                            },
                            [&](std::size_t less) { return known_to_fit(with_less(less), bound, cores); }};
        choice[i].depth = deepest - last_that_holds(deepest - shallowest + 1, jobs_, fits);
    }
    return choice;
}

}  // namespace faster::sizing
