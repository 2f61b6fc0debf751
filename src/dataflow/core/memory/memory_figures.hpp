#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "dataflow/base/cycles.hpp"

namespace dataflow::timing {

/// How many bursts took how long. Nearly all are among the short ones, which are counted without a search.
class LatencyCounts {
  public:
    void add(Cycles latency) { ++(latency < short_.size() ? short_[latency] : long_[latency]); }
    /// The smallest that so many bursts do not exceed; not more than there are.
    Cycles reached_by(std::uint64_t bursts) const {
        std::uint64_t seen = 0;
        for (Cycles latency = 0; latency < short_.size(); ++latency)
            if ((seen += short_[latency]) >= bursts)
                return latency;
        for (auto const& [latency, count] : long_)
            if ((seen += count) >= bursts)
                return latency;
        return 0;
    }

  private:
    std::vector<std::uint64_t> short_ = std::vector<std::uint64_t>(1024);  ///< by latency
    std::map<Cycles, std::uint64_t> long_;
};

/// What happened at one master.
struct MasterFigures {
    std::uint64_t bursts = 0;
    std::uint64_t beats = 0;
    LatencyCounts latencies;  ///< from asking to the last beat
};

/// How the controller was doing over time: stretches of equal length, which doubles whenever there are too many.
class ControllerHistory {
  public:
    static constexpr std::size_t most_stretches = 512;
    struct Stretch {
        std::uint64_t beats = 0;          ///< of bursts that arrived in it
        std::uint64_t largest_queue = 0;  ///< found by one of those, itself included
    };

    void arrived(Cycles cycle, std::uint64_t beats, std::uint64_t queue) {
        while (cycle / stretch_cycles_ >= most_stretches)
            double_stretches();
        std::size_t const at = cycle / stretch_cycles_;
        if (at >= stretches_.size())
            stretches_.resize(at + 1);
        stretches_[at].beats += beats;
        stretches_[at].largest_queue = std::max(stretches_[at].largest_queue, queue);
    }
    Cycles stretch_cycles() const { return stretch_cycles_; }
    std::vector<Stretch> const& stretches() const { return stretches_; }

  private:
    void double_stretches() {
        for (std::size_t i = 0; i < stretches_.size(); ++i) {
            Stretch const from = stretches_[i];
            Stretch& to = stretches_[i / 2];
            to = i % 2 == 0 ? from : Stretch{to.beats + from.beats, std::max(to.largest_queue, from.largest_queue)};
        }
        stretches_.resize((stretches_.size() + 1) / 2);
        stretch_cycles_ *= 2;
    }

    Cycles stretch_cycles_ = 64;
    std::vector<Stretch> stretches_;
};

struct ControllerFigures {
    std::uint64_t granules = 0;
    std::uint64_t largest_queue = 0;  ///< bursts that have arrived and not begun
    ControllerHistory history;
};

}  // namespace dataflow::timing
