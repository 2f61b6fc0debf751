#pragma once
#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "dataflow/run/figures/sample_timeline.hpp"

namespace dataflow::recording {

/// A value over the cycles of a window, as a timeline draws it: the largest at the end of any cycle of a stretch.
/// Stretches begin at multiples of their length; the first one at the window's begin.
class LargestInStretches {
  public:
    LargestInStretches(Cycles from, Cycles to, Cycles stretch) : from_(from), to_(to), stretch_(stretch) {}

    /// From the end of a cycle on; of several in one cycle the last counts. Cycles come in order, from 0 on.
    void take(Cycles cycle, std::uint64_t value) {
        if (cycle > to_)  // decoupled goes beyond the end of the run
            return;
        if (cycle != cycle_)
            come_to(cycle);
        value_ = value;
    }
    std::vector<OccupancyPoint> finish() {
        keep();
        put(begin_, largest_);
        put(begin_ + stretch_, value_);
        return std::move(points_);
    }

  private:
    void come_to(Cycles cycle) {
        Cycles const begin = cycle / stretch_ * stretch_;
        keep();
        if (begin != begin_) {
            put(begin_, largest_);
            if (begin > begin_ + stretch_)
                put(begin_ + stretch_, value_);
            begin_ = begin;
            largest_ = cycle > begin ? value_ : 0;
        }
        cycle_ = cycle;
    }
    void keep() { largest_ = cycle_ < from_ ? value_ : std::max(largest_, value_); }
    void put(Cycles cycle, std::uint64_t value) {
        if (cycle > to_)
            return;
        Cycles const at = std::max(cycle, from_);
        if (!points_.empty() && points_.back().cycle == at)
            points_.back().tokens = value;
        else if (points_.empty() || points_.back().tokens != value)
            points_.push_back({at, value});
    }

    Cycles from_;
    Cycles to_;
    Cycles stretch_;
    Cycles cycle_ = 0;  ///< from whose end on the value is there
    Cycles begin_ = 0;  ///< of the stretch at hand
    std::uint64_t value_ = 0;
    std::uint64_t largest_ = 0;  ///< of the stretch at hand, before that cycle
    std::vector<OccupancyPoint> points_;
};

}  // namespace dataflow::recording
