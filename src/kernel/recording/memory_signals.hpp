#pragma once
#include <vector>

#include "kernel/recording/memory_changes.hpp"
#include "kernel/recording/waveform.hpp"

namespace faster::recording {

/// The signals of an external memory in a waveform.
class MemorySignals {
  public:
    /// `memory` must outlive it.
    MemorySignals(Waveform& waveform, RecordedMemory const& memory, std::size_t domain);

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

}  // namespace faster::recording
