#include "dataflow/tools/sizing/search.hpp"

#include <algorithm>
#include <atomic>
#include <optional>

#include "dataflow/base/on_threads.hpp"
#include "dataflow/tools/sizing/last_that_holds.hpp"

namespace dataflow::sizing {

namespace {

/// All FIFOs are to blame, which is always true of a choice that breaks a bound.
Cut everybody(Choice const& choice) {
    Cut cut;
    for (std::size_t i = 0; i < choice.size(); ++i)
        cut.members.push_back({i, choice[i].capacity(), choice[i].read_latency() > 1});
    return cut;
}

bool may_be_shift_register(FifoFreedom const& fifo) { return fifo.kind != FifoKind::memory; }

}  // namespace

Search::Search(FifoFrame const& frame, CoreTimes& times, Unbounded const& unbounded, SearchOptions const& options,
               Search const* relaxed)
    : frame_(frame),
      times_(times),
      unbounded_(unbounded),
      options_(options),
      relaxed_(relaxed),
      jobs_(std::max(1U, options.jobs)),
      strict_core_(unbounded.last_core) {
    for (std::size_t i = 0; i < frame.fifos(); ++i) {
        std::uint64_t const tokens = std::min(most_depth, std::max<std::uint64_t>(1, times.tokens()[i]));
        levels_.push_back(levels_of(frame.freedoms[i], tokens, frame.weights));
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
    return cost_of(sum_of(choice, frame_.freedoms, frame_.weights), frame_.weights);
}

std::vector<Cut> Search::cuts_against(Cycles bound) const {
    std::vector<Cut> cuts = relaxed_ == nullptr ? std::vector<Cut>() : relaxed_->cuts_against(bound);
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
        if (found.is_proven || times_.retimed_cores() >= options_.most_retimings)
            break;
    }
    found.is_given_up = !found.is_proven;
    if (found.is_given_up)
        found.choice = descend(bound);
    return found;
}

Found Search::timed(Found found) {
    found.total_cycles = times_.total_cycles(found.choice, jobs_);
    return found;
}

/// Why a choice breaks the bound; false: it does not. The core that broke the last bound is asked first, and why at
/// once.
bool Search::learn(Choice const& choice, Cycles bound) {
    std::optional<Cut> cut;
    if (times_.cores() > 0 && times_.known_to_exceed(strict_core_, choice, bound).value_or(true))
        cut = suspects(choice, bound);
    std::size_t const core = broken_core(choice, bound);
    if (core == times_.cores())
        return false;
    if (!cut || cut->total_cycles <= bound)
        cut = times_.suspects(core, choice, bound);
    if (!times_.exceeds(core, corner(*cut), bound))  // the suspects are not all who are to blame
        cut = everybody(choice);
    cuts_.push_back(widened(*cut, core, bound));
    return true;
}

/// Of the strict core: those of the last cut, if they are to blame again and that is found out sooner. Who they are
/// makes no difference to what is found in the end.
Cut Search::suspects(Choice const& choice, Cycles bound) {
    Cut same = cuts_.empty() ? Cut() : cuts_.back();
    for (Cut::Member& member : same.members) {
        FifoChoice const& fifo = choice[member.fifo];
        member.capacity = fifo.capacity();
        member.is_slow = member.is_slow && fifo.read_latency() > 1;
    }
    std::optional<Cut> cut;
    std::atomic<bool> is_found = false;
    std::atomic<bool> is_same = false;
    auto const is_beaten = [&] { return is_found && !options_.has_repeatable_cuts; };
    auto const ask_same = [&] {
        if (!same.members.empty() && times_.exceeds(strict_core_, corner(same), bound, is_beaten).value_or(false))
            is_same = true;
    };
    auto const look = [&] {
        cut = times_.suspects(strict_core_, choice, bound, [&] { return is_same.load(); });
        is_found = cut.has_value();
    };
    bool const asks_first = options_.has_repeatable_cuts && jobs_ == 1;
    on_threads(jobs_ > 1 ? 2 : 1, jobs_, [&](std::size_t i) {
        if (i == 1 || asks_first)
            ask_same();
        if (i == 0 && !is_same)
            look();
    });
    if (cut && !(is_same && options_.has_repeatable_cuts))
        return *cut;
    same.total_cycles = bound + 1;
    return same;
}

/// The slowest way to escape a cut: everything that it does not ask for is as quick as can be.
Choice Search::corner(Cut const& cut) const {
    Choice choice(frame_.fifos());
    for (std::size_t i = 0; i < choice.size(); ++i) {
        std::uint64_t capacity = timing::FifoShape::unlimited;
        FifoFreedom const& fifo = frame_.freedoms[i];
        bool is_memory = !may_be_shift_register(fifo);
        for (Cut::Member const& member : cut.members)
            if (member.fifo == i) {
                capacity = member.capacity > 0 ? member.capacity : capacity;
                is_memory = is_memory || member.is_slow;
            }
        choice[i] = fifo.with_capacity(is_memory ? FifoKind::memory : FifoKind::shift_register, capacity);
    }
    return choice;
}

/// Where times are not monotone, one that does not depend on the jobs.
std::size_t Search::last(std::size_t count, unsigned jobs, Monotone const& monotone) const {
    if (times_.is_monotone())
        return last_that_holds(count, jobs, monotone);
    return last_before_failing(count, jobs, monotone.holds);
}

/// As many choices as can be ruled out with a cut that the bound is broken by.
Cut Search::widened(Cut cut, std::size_t core, Cycles bound) {
    drop_members(cut, core, bound);
    for (std::size_t i = 0; i < cut.members.size(); ++i)
        if (cut.members[i].capacity > 0)
            deepen_member(cut, i, core, bound);
    // That it breaks the bound may be known from a choice that is no slower, and nothing more.
    Cycles const least = options_.has_repeatable_cuts ? 0 : times_.least_cycles(core, corner(cut));
    cut.total_cycles = std::max(bound + 1, least);
    return cut;
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
    std::size_t const fifo = cut.members[member].fifo;
    std::vector<std::uint64_t> capacities{cut.members[member].capacity};
    for (Level const& level : levels_[fifo])
        if (level.choice.capacity() > capacities.front() &&
            level.choice.capacity() < unbounded_.choice[fifo].capacity())
            capacities.push_back(level.choice.capacity());
    capacities.push_back(timing::FifoShape::unlimited);
    std::sort(capacities.begin(), capacities.end());
    auto const corner_at = [&](std::size_t i) {
        Cut deeper = cut;
        deeper.members[member].capacity = capacities[i];
        return corner(deeper);
    };
    Monotone const breaks{
        [&](std::size_t i, auto const& is_obsolete) { return times_.exceeds(core, corner_at(i), bound, is_obsolete); },
        [&](std::size_t i) { return times_.known_to_exceed(core, corner_at(i), bound); }};
    std::size_t const deepest = last(capacities.size(), jobs_, breaks);
    cut.members[member].capacity =
        deepest + 1 < capacities.size() ? capacities[deepest] : 0;  // however deep: it is too slow
}

/// Unbounded FIFOs such as an answer may have.
Choice Search::deepest() const {
    Choice choice = unbounded_.choice;
    for (std::size_t i = 0; i < choice.size(); ++i)
        choice[i] = as_it_may_be(choice[i], frame_.freedoms[i]);
    for (std::size_t const fifo : frame_.freezing)  // so deep that it never freezes, whatever the others are
        choice[fifo] =
            frame_.freedoms[fifo].at_depth(std::max(choice[fifo].depth, std::min(most_depth, times_.tokens()[fifo])));
    return choice;
}

/// From unbounded FIFOs down, one after the other, until none can be had for less.
Choice Search::descend(Cycles bound) {
    Choice choice = times_.are_together() ? unbounded_.choice : deepest();
    for (bool is_cheaper = true; is_cheaper;) {
        is_cheaper = false;
        for (std::size_t i = 0; i < choice.size(); ++i)
            is_cheaper = cheapen(choice, i, bound) || is_cheaper;
    }
    return choice;
}

bool Search::cheapen(Choice& choice, std::size_t fifo, Cycles bound) {
    double const cost = cost_of(primitives_of(choice[fifo], frame_.freedoms[fifo], frame_.weights), frame_.weights);
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
        Monotone const fits{[&](std::size_t i, auto const& /*is_obsolete*/) { return is_within_at(i); },
                            [](std::size_t) { return std::nullopt; }};
        choice[fifo] = levels[last(levels.size(), 1, fits)].choice;
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
            break;
        }
        cores.push_back(broken);
    }
    return timed(found);
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

/// Nothing if it became obsolete.
std::optional<bool> Search::fits_cores(Choice const& choice, Cycles bound, std::vector<std::size_t> const& cores,
                                       Monotone::IsObsolete const& is_obsolete) {
    for (std::size_t const core : cores) {
        std::optional<bool> const exceeds = times_.exceeds(core, choice, bound, is_obsolete);
        if (!exceeds || *exceeds)
            return exceeds ? std::optional(false) : std::nullopt;
    }
    return true;
}

/// Where only one depth less is in question, asks at the same time what comes next if the FIFO can do with it.
void Search::ask_ahead(Choice choice, std::size_t fifo, Cycles bound, std::vector<std::size_t> const& cores) {
    std::vector<Choice> questions;
    for (; fifo < choice.size() && questions.size() < jobs_; ++fifo) {
        if (choice[fifo].depth == 1)
            continue;
        --choice[fifo].depth;
        questions.push_back(choice);
    }
    on_threads(questions.size(), jobs_, [&](std::size_t i) { fits_cores(questions[i], bound, cores, nullptr); });
}

/// Looks at some cores only.
Choice Search::without_spare_tokens(Choice choice, Cycles bound, std::vector<std::size_t> const& cores) {
    for (std::size_t i = 0; i < choice.size(); ++i) {
        std::uint64_t const deepest = choice[i].depth;
        std::uint64_t shallowest = deepest;
        while (shallowest > 1 && frame_.freedoms[i].at_depth(shallowest - 1).kind == choice[i].kind)
            --shallowest;
        auto const with_less = [&, before = choice](std::size_t less) {
            Choice shallower = before;
            shallower[i].depth = deepest - less;
            return shallower;
        };
        Monotone const fits{[&](std::size_t less, auto const& is_obsolete) {
                                return fits_cores(with_less(less), bound, cores, is_obsolete);
                            },
                            [&](std::size_t less) { return known_to_fit(with_less(less), bound, cores); }};
        if (deepest - shallowest == 1 && !known_to_fit(with_less(1), bound, cores))
            ask_ahead(choice, i, bound, cores);
        choice[i].depth = deepest - last(deepest - shallowest + 1, jobs_, fits);
    }
    return choice;
}

}  // namespace dataflow::sizing
