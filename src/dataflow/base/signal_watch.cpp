#include "dataflow/base/signal_watch.hpp"

#include <cerrno>
#include <cstring>
#include <string>
#include <sys/signalfd.h>
#include <unistd.h>

#include "dataflow/base/input_error.hpp"

namespace dataflow::processes {

SignalWatch::SignalWatch() {
    sigset_t const watched = ending_signals();
    descriptor_ = signalfd(-1, &watched, SFD_CLOEXEC | SFD_NONBLOCK);
    if (descriptor_ < 0)
        throw HostError(std::string("no descriptor to watch for signals (") + std::strerror(errno) +
                        "), expected room for more open files");
}

SignalWatch::~SignalWatch() { close(descriptor_); }

void SignalWatch::take() const {
    signalfd_siginfo signal{};
    while (read(descriptor_, &signal, sizeof signal) > 0) {
    }
}

}  // namespace dataflow::processes
