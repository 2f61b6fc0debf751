#pragma once
#include "dataflow/base/held_signals.hpp"

namespace dataflow::processes {

/// HeldSignals for who waits: polls descriptor(), and throws Interrupted once it is readable.
class SignalWatch {
  public:
    /// Throws InputError if there is no descriptor left.
    SignalWatch() : descriptor_(descriptor_of_signals()) {}

    /// Readable as soon as a signal has come.
    int descriptor() const { return descriptor_; }
    /// Takes a signal that has come as done with: it does not end the program any more.
    void take() const { forget_signal(); }

  private:
    HeldSignals held_;
    int descriptor_;
};

}  // namespace dataflow::processes
