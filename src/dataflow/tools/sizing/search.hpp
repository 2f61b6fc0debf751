#pragma once
#include <optional>
#include <vector>

#include "dataflow/tools/sizing/cheapest_choice.hpp"
#include "dataflow/tools/sizing/core_times.hpp"
#include "dataflow/tools/sizing/last_that_holds.hpp"
#include "dataflow/tools/sizing/unbounded.hpp"

namespace dataflow::sizing {

/// The cheapest choice within a bound, and how sure that is.
struct Found {
    Choice choice;
    Cycles total_cycles = 0;   ///< once timed
    bool is_proven = false;    ///< no choice within the bound is cheaper
    bool is_given_up = false;  ///< not proven, as that would have taken too many retimings
    bool is_repaired = false;  ///< what the relaxed machine needs is not enough
    double least_cost = 0;     ///< LUTs of a core; no choice within the bound costs less, proven or not
};

struct SearchOptions {
    unsigned jobs = 1;
    std::size_t most_retimings = 0;    ///< cores retimed in all before a search settles for less than a proof
    bool has_repeatable_cuts = false;  ///< the same whatever the threads do, as another search rests on them
};

/// Searches for the cheapest FIFOs. Keeps the cuts of earlier searches.
///
/// The cheapest levels that escape all known cuts are timed. If they are within the bound they are the answer, as
/// nothing cheaper escapes. If not, the critical path says why, which is a new cut. It is deepened as far as it still
/// breaks the bound with all other FIFOs unlimited, so that it rules out as much as it can; that is retimed too.
/// This takes for granted that more room or less latency never makes a run longer: docs/architecture.md says why. Where
/// times are not monotone, what it finds is within the bound and good, but proven to be nothing.
class Search {
  public:
    /// `relaxed`: a search on the relaxed machine, of which all cuts hold here too.
    Search(FifoFrame const& frame, CoreTimes& times, Unbounded const& unbounded, SearchOptions const& options,
           Search const* relaxed = nullptr);

    /// At most `bound` cycles, which must be no less than unbounded FIFOs take; Cut::deadlock - 1: any that end.
    Found cheapest(Cycles bound);
    Found timed(Found found);
    /// A choice of equal price with no token more than needed; timed.
    Found shallowest(Found found, Cycles bound);
    bool is_within(Choice const& choice, Cycles bound);
    double cost_of_choice(Choice const& choice) const;

  private:
    std::size_t broken_core(Choice const& choice, Cycles bound);
    bool learn(Choice const& choice, Cycles bound);
    Cut suspects(Choice const& choice, Cycles bound);
    Cut widened(Cut cut, std::size_t core, Cycles bound);
    void drop_members(Cut& cut, std::size_t core, Cycles bound);
    void deepen_member(Cut& cut, std::size_t member, std::size_t core, Cycles bound);
    Choice corner(Cut const& cut) const;
    std::vector<Cut> cuts_against(Cycles bound) const;
    Choice deepest() const;
    Choice descend(Cycles bound);
    bool cheapen(Choice& choice, std::size_t fifo, Cycles bound);
    std::optional<bool> known_to_fit(Choice const& choice, Cycles bound, std::vector<std::size_t> const& cores) const;
    std::optional<bool> fits_cores(Choice const& choice, Cycles bound, std::vector<std::size_t> const& cores,
                                   Monotone::IsObsolete const& is_obsolete);
    void ask_ahead(Choice choice, std::size_t fifo, Cycles bound, std::vector<std::size_t> const& cores);
    Choice without_spare_tokens(Choice choice, Cycles bound, std::vector<std::size_t> const& cores);
    std::size_t last(std::size_t count, unsigned jobs, Monotone const& monotone) const;

    FifoFrame const& frame_;
    CoreTimes& times_;
    Unbounded const& unbounded_;
    SearchOptions const options_;
    Search const* const relaxed_;
    unsigned const jobs_;
    Levels levels_;
    std::vector<Cut> cuts_;
    std::size_t strict_core_;  ///< the one that broke the last bound; it will probably break the next
};

}  // namespace dataflow::sizing
