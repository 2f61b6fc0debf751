#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "kernel/base/cycles.hpp"

namespace faster::timing {

/// What happened at one master.
struct MasterFigures {
    std::uint64_t bursts = 0;
    std::uint64_t beats = 0;
    std::map<Cycles, std::uint64_t> latencies;  ///< bursts by the cycles from asking to their last beat
};

struct PortFigures {
    std::uint64_t beats = 0;  ///< that it brought to the cores
};

/// How the controller was doing over time: stretches of equal length, which doubles whenever there are too many.
class ControllerHistory {
  public:
    static constexpr std::size_t most_stretches = 512;
    struct Stretch {
        std::uint64_t granules = 0;       ///< of bursts that arrived in it
        std::uint64_t largest_queue = 0;  ///< found by one of those, itself included
    };

    void arrived(Cycles cycle, std::uint64_t granules, std::uint64_t queue) {
        while (cycle / stretch_cycles_ >= most_stretches)
            double_stretches();
        std::size_t const at = cycle / stretch_cycles_;
        if (at >= stretches_.size())
            stretches_.resize(at + 1);
        stretches_[at].granules += granules;
        stretches_[at].largest_queue = std::max(stretches_[at].largest_queue, queue);
    }
    Cycles stretch_cycles() const { return stretch_cycles_; }
    std::vector<Stretch> const& stretches() const { return stretches_; }

  private:
    void double_stretches() {
        for (std::size_t i = 0; i < stretches_.size(); ++i) {
            Stretch const from = stretches_[i];
            Stretch& to = stretches_[i / 2];
            to = i % 2 == 0 ? from
                            : Stretch{to.granules + from.granules, std::max(to.largest_queue, from.largest_queue)};
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

}  // namespace faster::timing
