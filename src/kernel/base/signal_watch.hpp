#pragma once
#include <csignal>
#include <stdexcept>

namespace faster::processes {

/// Thrown where work is given up because somebody wants the program to end.
class Interrupted : public std::runtime_error {
  public:
    Interrupted() : std::runtime_error("interrupted") {}
};

/// Holds back SIGINT, SIGTERM and SIGHUP while it lives, so that files are written whole and processes are not left
/// behind. Whoever waits polls descriptor(), and throws Interrupted once it is readable. The destructor lets the signal
/// through, which then ends the program as it always does. Signals that the caller ignores stay ignored.
class SignalWatch {
  public:
    SignalWatch();
    ~SignalWatch();
    SignalWatch(SignalWatch const&) = delete;
    SignalWatch& operator=(SignalWatch const&) = delete;

    /// Readable as soon as a signal has come.
    int descriptor() const { return descriptor_; }
    /// Takes a signal that has come as done with: it does not end the program any more.
    void take() const;
    /// For a child process: signals are as they were before.
    void release_in_child() const;

  private:
    sigset_t before_{};
    int descriptor_ = -1;
};

}  // namespace faster::processes
