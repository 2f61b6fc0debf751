#include "sizing/search.hpp"

#include <algorithm>
#include <functional>
#include <optional>

#include "common/on_threads.hpp"
#include "sizing/token_bits.hpp"

namespace faster::sizing {

namespace {

constexpr std::uint64_t first_depth = 64;
constexpr std::uint64_t growth = 8;

bool may_be_shift_register(FifoKind configured) { return configured != FifoKind::memory; }

/// Something that holds for the first of some numbers, and for all up to one.
struct Monotone {
    std::function<bool(std::size_t)> holds;
    std::function<std::optional<bool>(std::size_t)> is_known_to_hold;  ///< without working it out
};

/// The number of the first of 0 .. count - 1 for which `holds` is false, as it is from there on.
std::size_t first_without(std::size_t count, std::function<bool(std::size_t)> const& holds) {
    std::size_t first = 0;
    for (std::size_t end = count; first < end;) {
        std::size_t const middle = first + (end - first) / 2;
        holds(middle) ? first = middle + 1 : end = middle;
    }
    return first;
}

/// The last of 0 .. count - 1 for which it holds. Works out as many at once as there are jobs.
std::size_t last_that(std::size_t count, unsigned jobs, Monotone const& monotone) {
    auto const known_or = [&](bool otherwise) {
        return first_without(count, [&](std::size_t i) { return monotone.is_known_to_hold(i).value_or(otherwise); });
    };
    std::size_t const known = known_or(false);
    std::size_t yes = known == 0 ? 0 : known - 1;
    std::size_t no = known_or(true);
    while (no - yes > 1) {
        std::size_t const probes = std::min<std::size_t>(std::max(1U, jobs), no - yes - 1);
        std::vector<char> held(probes);
        auto const place = [&](std::size_t i) { return yes + (no - yes) * (i + 1) / (probes + 1); };
        on_threads(probes, jobs, [&](std::size_t i) { held[i] = monotone.holds(place(i)) ? 1 : 0; });
        auto const passed = static_cast<std::size_t>(std::find(held.begin(), held.end(), 0) - held.begin());
        std::size_t const old_no = no;
        no = passed < probes ? place(passed) : old_no;
        if (passed > 0) {
            std::size_t const i = passed - 1;
            yes = yes + (old_no - yes) * (i + 1) / (probes + 1);
        }
    }
    return yes;
}

}  // namespace

FifoFrame::FifoFrame(AcceleratorConfig const& config, CostWeights const& cost_weights) : weights(cost_weights) {
    for (std::size_t i = 0; i < fifo_count; ++i) {
        kinds[i] = config.fifos[i].kind;
        bits[i] = token_bits(static_cast<FifoId>(i), config);
    }
}

Unbounded unbounded(FifoFrame const& frame, CoreTimes& times, unsigned jobs) {
    Unbounded result;
    for (std::size_t i = 0; i < fifo_count; ++i)
        result.choice[i] = choice_of(frame.kinds[i], first_depth);
    for (;;) {
        result.total_cycles = times.total_cycles(result.choice, jobs);
        std::size_t last = 0;
        while (last < times.cores() && times.cycles(last, result.choice) != result.total_cycles)
            ++last;
        if (last == times.cores())  // no samples
            return result;
        bool is_deeper = true;
        while (is_deeper) {
            is_deeper = false;
            for (Cut::Member const& member : times.explain(last, result.choice).members) {
                FifoChoice& fifo = result.choice[index_of(member.fifo)];
                if (member.capacity == 0 || fifo.depth == most_depth)
                    continue;
                fifo.depth = std::min(most_depth, fifo.depth * growth);
                is_deeper = true;
            }
        }
        if (times.total_cycles(result.choice, jobs) == times.cycles(last, result.choice)) {
            result.total_cycles = times.cycles(last, result.choice);
            return result;
        }
    }
}

Search::Search(FifoFrame const& frame, CoreTimes& times, Unbounded const& unbounded, unsigned jobs,
               std::size_t most_retimings)
    : frame_(frame), times_(times), unbounded_(unbounded), jobs_(jobs), most_retimings_(most_retimings) {
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
        cut = times_.explain(strict_core_, choice);
    std::size_t const core = broken_core(choice, bound);
    if (core == times_.cores())
        return false;
    if (!cut || cut->total_cycles <= bound)
        cut = times_.explain(core, choice);
    for (std::size_t i = 0; i < fifo_count; ++i)
        room_[i] = std::max(room_[i], choice[i].capacity());  // so that the cut rules this choice out
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

Cut Search::widened(Cut cut, std::size_t core, Cycles bound) {
    drop_members(cut, core, bound);
    for (std::size_t i = 0; i < cut.members.size(); ++i)
        if (cut.members[i].capacity > 0)
            deepen_member(cut, i, core, bound);
    return times_.explain(core, corner(cut));
}

void Search::drop_members(Cut& cut, std::size_t core, Cycles bound) {
    for (std::size_t i = cut.members.size(); i-- > 0 && cut.members.size() > 1;) {
        Cut fewer = cut;
        fewer.members.erase(fewer.members.begin() + static_cast<std::ptrdiff_t>(i));
        if (times_.exceeds(core, corner(fewer), bound))
            cut = fewer;
    }
}

void Search::deepen_member(Cut& cut, std::size_t member, std::size_t core, Cycles bound) {
    std::vector<std::uint64_t> capacities{cut.members[member].capacity};
    for (Level const& level : levels_[index_of(cut.members[member].fifo)])
        if (level.choice.capacity() > capacities.front())
            capacities.push_back(level.choice.capacity());
    std::sort(capacities.begin(), capacities.end());
    auto const corner_at = [&](std::size_t i) {
        Cut deeper = cut;
        deeper.members[member].capacity = capacities[i];
        return corner(deeper);
    };
    Monotone const breaks{[&](std::size_t i) { return times_.exceeds(core, corner_at(i), bound); },
                          [&](std::size_t i) { return times_.known_to_exceed(core, corner_at(i), bound); }};
    cut.members[member].capacity = capacities[last_that(capacities.size(), jobs_, breaks)];
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
        choice[fifo] = levels[last_that(levels.size(), 1, fits)].choice;
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
        choice[i].depth = deepest - last_that(deepest - shallowest + 1, jobs_, fits);
    }
    return choice;
}

}  // namespace faster::sizing
