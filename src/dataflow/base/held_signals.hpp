#pragma once
#include <stdexcept>

namespace dataflow::processes {

/// Thrown where work is given up because somebody wants the program to end.
class Interrupted : public std::runtime_error {
  public:
    Interrupted() : std::runtime_error("interrupted") {}
};

/// Holds back the signals that end a program (SIGINT, SIGTERM, SIGHUP, SIGPIPE) while it lives, so that what is
/// half-written can be taken away first: whoever writes for long calls give_up_if_interrupted() now and then. When the
/// last of all threads has gone, a signal that came ends the program as it always does. Signals that the caller
/// ignores stay ignored.
///
/// Who asks twice is not made to wait: a second SIGINT, SIGTERM or SIGHUP, a fifth of a second or more after the first,
/// ends the program at once, and what is half-written stays behind under its hidden name. (Sooner it is the same
/// request: `timeout` sends its signal to the process and to its group.)
class HeldSignals {
  public:
    HeldSignals();
    ~HeldSignals();
    HeldSignals(HeldSignals const&) = delete;
    HeldSignals& operator=(HeldSignals const&) = delete;
};

/// Throws Interrupted if a signal is held back.
void give_up_if_interrupted();

/// The signal that came is done with: it does not end the program any more. A second one still does.
void forget_signal();

/// A descriptor that is readable while a signal is held back; the same for all who ask, and never closed. Throws
/// HostError if there is none left.
int descriptor_of_signals();

/// For a child process, which is not to hold back what its parent holds back.
void let_signals_through();

}  // namespace dataflow::processes
