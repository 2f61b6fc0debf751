#pragma once
#include <vector>

#include "dataflow/core/time/core_timing.hpp"
#include "dataflow/core/time/path_sums.hpp"
#include "dataflow/core/time/trail.hpp"

namespace dataflow::timing {

/// Walks from where processes stand back along what decided their times. A process goes its own way from the end of its
/// last wait; that ended because of what the process at the FIFO's other end had done before. Where several accesses of
/// a step were waited for, the one that became legal last decides; of those that became legal together, the first in
/// program order.
class PathSweep {
  public:
    /// Stands at an access of a process, or after everything it has done; or at a token that leaves its flushing
    /// pipeline, of which it is not the process's own time that decides.
    struct Position {
        unsigned process = 0;
        Cycles time = 0;
        bool flies = false;
    };
    static constexpr Cycles everything = ~Cycles{0};

    PathSweep(CoreTiming const& core, std::vector<Position> const& from);
    /// Another sweep, of what this one has left and from where it is.
    PathSweep from_here() const;

    /// Back to cycle 0, or what is left of the trail. One position only.
    void to_the_start();
    /// Until one position is left; false if it does not come to that.
    bool to_a_junction();

    /// The only one.
    Position position() const;
    /// Of one position, from the beginning of the sweep; with to_the_start(), from cycle 0 on.
    PathSums& sums() { return sums_; }
    /// What of the trail was not swept.
    std::size_t events_left() const { return next_event_; }
    std::size_t transitions_left() const { return next_transition_; }

  private:
    using Events = std::vector<TrailEvent>;
    using Standing = std::vector<std::vector<Cycles>>;  // by process, ascending; then those that fly

    std::size_t place(Position const& position) const {
        return position.process + (position.flies ? standing_.size() / 2 : 0);
    }
    void stand(Position position);
    void pass_next();
    void pass(Events const& events, std::size_t from, std::size_t until, Cycles later);
    void pass_one(Events const& events, std::size_t i, Cycles later);
    void pass_repeated(Events const& events, std::size_t i, Cycles later);
    bool is_earlier_by(Standing const& before, Cycles cycles) const;
    void go_back(Cycles cycles);
    std::uint32_t periods_to_pass(Events const& events, std::size_t i, Cycles later) const;
    void pass_followed(TrailEvent const& event);
    void turn(TrailEvent const& event, Cycles time);
    void land(TrailEvent const& event, Cycles time);
    Position origin(TrailEvent const& event, Cycles time);
    void add_own(unsigned process, Region region, Cycles step, Cycles cycles);

    CoreTiming const& core_;
    Trail const& trail_;
    Standing standing_;
    std::size_t positions_ = 0;
    PathSums sums_;
    std::size_t next_event_;
    std::size_t next_transition_;
};

/// What the path that ends with an access by a process of a core spent its cycles with, from cycle 0 on: they add up to
/// the access's cycle. The core must have left a trail from the beginning, and have been resolved.
PathSums critical_path(CoreTiming const& core, unsigned process, Cycles access);

/// Replaces the part of a core's trail that all paths have in common, now and later, by what they spent in it.
void forget_trunk(CoreTiming const& core, Trail& trail);

}  // namespace dataflow::timing
