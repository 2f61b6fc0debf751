#pragma once
#include <cstdint>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

#include "dataflow/tools/recording/memory_recorder.hpp"
#include "dataflow/tools/recording/waveform.hpp"

namespace dataflow::recording {

/// Goes through what was recorded of a memory, change by change.
class MemoryChanges {
  public:
    struct Port {
        std::uint64_t reads = 0;    ///< whose beats are under way: 0 or 1
        std::uint64_t waiting = 0;  ///< bursts asked for, without a beat or acknowledgement so far
        std::uint64_t bytes = 0;    ///< of bursts done, since the run began
    };
    struct Controller {
        std::uint64_t serving = 0;  ///< bursts that begin, go on or end in the cycle
        std::uint64_t queue = 0;    ///< bursts that have arrived and not begun
    };

    /// `memory` must outlive it.
    explicit MemoryChanges(RecordedBursts const& memory);

    /// ~0: there are none left.
    Cycles next_cycle() const;
    /// Goes on to the next change. Returns the number of its port; no port's: the controller's.
    std::size_t go_on();

    std::vector<Port> const& ports() const { return ports_; }
    Controller const& controller() const { return controller_; }

  private:
    enum class Kind { asked, first_beat, done, arrived, begun, served };
    struct Change {
        Cycles cycle;
        Kind kind;
        timing::ServedBurst const* burst;
        /// Within a cycle a burst arrives before it begins.
        bool operator>(Change const& other) const {
            return std::pair(cycle, kind) > std::pair(other.cycle, other.kind);
        }
    };
    void take_up(timing::ServedBurst const& burst);

    RecordedBursts const& memory_;
    std::size_t next_ = 0;  ///< burst that has not been asked for
    std::priority_queue<Change, std::vector<Change>, std::greater<>> changes_;
    std::vector<Port> ports_;
    Controller controller_;
};

/// The signals of an external memory in a waveform.
class MemorySignals {
  public:
    /// `memory` must outlive it.
    MemorySignals(Waveform& waveform, RecordedBursts const& memory, std::size_t domain);

    /// ~0: nothing changes any more.
    Cycles next_change() const { return changes_.next_cycle(); }
    /// The waveform stands at that cycle.
    void change();

  private:
    struct PortSignals {
        Waveform::Signal busy, waiting, bytes;
    };
    Waveform& waveform_;
    MemoryChanges changes_;
    std::vector<PortSignals> ports_;
    Waveform::Signal controller_busy_ = 0, queue_ = 0;
};

}  // namespace dataflow::recording
