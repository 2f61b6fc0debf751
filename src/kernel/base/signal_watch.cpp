#include "kernel/base/signal_watch.hpp"

#include <cerrno>
#include <cstring>
#include <string>
#include <sys/signalfd.h>
#include <unistd.h>

#include "kernel/base/input_error.hpp"

namespace faster::processes {

namespace {

bool is_ignored(int signal) {
    struct sigaction action {};
    return sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

sigset_t watched_signals() {
    sigset_t set;
    sigemptyset(&set);
    for (int const signal : {SIGINT, SIGTERM, SIGHUP})
        if (!is_ignored(signal))
            sigaddset(&set, signal);
    return set;
}

}  // namespace

SignalWatch::SignalWatch() {
    sigset_t const watched = watched_signals();
    sigprocmask(SIG_BLOCK, &watched, &before_);
    descriptor_ = signalfd(-1, &watched, SFD_CLOEXEC | SFD_NONBLOCK);
    if (descriptor_ < 0) {
        sigprocmask(SIG_SETMASK, &before_, nullptr);
        throw InputError(std::string("no descriptor to watch for signals (") + std::strerror(errno) +
                         "), expected room for more open files");
    }
}

SignalWatch::~SignalWatch() {
    close(descriptor_);
    sigprocmask(SIG_SETMASK, &before_, nullptr);
}

void SignalWatch::take() const {
    signalfd_siginfo signal{};
    while (read(descriptor_, &signal, sizeof signal) > 0) {
    }
}

void SignalWatch::release_in_child() const { sigprocmask(SIG_SETMASK, &before_, nullptr); }

}  // namespace faster::processes
