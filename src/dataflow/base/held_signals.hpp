#pragma once
#include <array>
#include <csignal>
#include <stdexcept>

namespace dataflow::processes {

/// Thrown where work is given up because somebody wants the program to end.
class Interrupted : public std::runtime_error {
  public:
    Interrupted() : std::runtime_error("interrupted") {}
};

/// Holds back the signals that end a program (SIGINT, SIGTERM, SIGHUP, SIGPIPE) while it lives, so that what is
/// half-written can be taken away first: whoever writes for long calls give_up_if_interrupted() now and then. The
/// destructor lets a signal through, which then ends the program as it always does. Of several, the one made last has
/// to go first, and only the first lets signals through. Signals that the caller ignores stay ignored. It belongs to
/// the program's first thread; what comes to another is handed on to that one.
class HeldSignals {
  public:
    HeldSignals();
    ~HeldSignals();
    HeldSignals(HeldSignals const&) = delete;
    HeldSignals& operator=(HeldSignals const&) = delete;

  private:
    sigset_t before_{};
    std::array<struct sigaction, 4> actions_before_{};
};

/// Those that are held back: all but the ignored ones.
sigset_t ending_signals();

/// Throws Interrupted if a signal is held back.
void give_up_if_interrupted();

/// For a child process, which is not to hold back what its parent holds back.
void let_signals_through();

}  // namespace dataflow::processes
