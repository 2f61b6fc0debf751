#include "dataflow/base/held_signals.hpp"

#include <cerrno>
#include <sys/syscall.h>
#include <unistd.h>

namespace dataflow::processes {

namespace {

bool is_ignored(int signal) {
    struct sigaction action {};
    return sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

constexpr std::array<int, 4> all_ending_signals{SIGINT, SIGTERM, SIGHUP, SIGPIPE};

/// To the thread that holds signals back: libraries have others, started before.
void hand_on(int signal) {
    int const error = errno;
    syscall(SYS_tgkill, getpid(), getpid(), signal);
    errno = error;
}

}  // namespace

sigset_t ending_signals() {
    sigset_t set;
    sigemptyset(&set);
    for (int const signal : all_ending_signals)
        if (!is_ignored(signal))
            sigaddset(&set, signal);
    return set;
}

HeldSignals::HeldSignals() {
    sigset_t const held = ending_signals();
    pthread_sigmask(SIG_BLOCK, &held, &before_);
    struct sigaction action {};
    action.sa_handler = hand_on;
    action.sa_flags = SA_RESTART;
    for (std::size_t i = 0; i < all_ending_signals.size(); ++i)
        if (sigismember(&held, all_ending_signals[i]) == 1)
            sigaction(all_ending_signals[i], &action, &actions_before_[i]);
        else
            actions_before_[i].sa_handler = SIG_IGN;
}

HeldSignals::~HeldSignals() {
    for (std::size_t i = 0; i < all_ending_signals.size(); ++i)
        sigaction(all_ending_signals[i], &actions_before_[i], nullptr);
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

void give_up_if_interrupted() {
    sigset_t pending;
    sigpending(&pending);
    for (int const signal : all_ending_signals)
        if (sigismember(&pending, signal) == 1)
            throw Interrupted();
}

void let_signals_through() {
    sigset_t const held = ending_signals();
    for (int const signal : all_ending_signals)
        if (sigismember(&held, signal) == 1)
            std::signal(signal, SIG_DFL);
    pthread_sigmask(SIG_UNBLOCK, &held, nullptr);
}

}  // namespace dataflow::processes
