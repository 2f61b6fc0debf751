#include "dataflow/base/held_signals.hpp"

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <ctime>
#include <mutex>
#include <new>
#include <string>
#include <sys/eventfd.h>
#include <unistd.h>

#include "dataflow/base/input_error.hpp"

namespace dataflow::processes {

namespace {

constexpr std::array<int, 4> all_ending_signals{SIGINT, SIGTERM, SIGHUP, SIGPIPE};
constexpr std::int64_t second_after_ms = 200;

/// Of the process: whatever thread a signal comes to, it is the same for all.
struct State {
    std::mutex mutex;  ///< of holders and before
    std::size_t holders = 0;
    std::array<struct sigaction, all_ending_signals.size()> before{};
    // What the handler may touch.
    std::atomic<int> signal{0};             ///< that came and is held back
    std::atomic<std::int64_t> first_ms{0};  ///< when the first came that asks the program to end; 0: none has
    std::atomic<int> descriptor{-1};
};

State& state() {
    static State held;
    return held;
}

static_assert(std::atomic<std::int64_t>::is_always_lock_free, "a handler may not wait for a lock");

std::int64_t now_ms() {
    timespec time{};
    clock_gettime(CLOCK_MONOTONIC, &time);
    return std::int64_t{time.tv_sec} * 1000 + time.tv_nsec / 1'000'000 + 1;
}

void end_by(int signal) {
    std::signal(signal, SIG_DFL);
    sigset_t one;
    sigemptyset(&one);
    sigaddset(&one, signal);
    pthread_sigmask(SIG_UNBLOCK, &one, nullptr);
    raise(signal);
}

/// A reader that went away says nothing about what somebody wants.
bool is_second_request(int signal) {
    if (signal == SIGPIPE)
        return false;
    std::int64_t const now = now_ms();
    std::int64_t none = 0;
    return !state().first_ms.compare_exchange_strong(none, now) && now - none >= second_after_ms;
}

void hold_back(int signal) {
    int const error = errno;
    if (is_second_request(signal))
        end_by(signal);
    int none = 0;
    state().signal.compare_exchange_strong(none, signal);
    if (int const descriptor = state().descriptor; descriptor >= 0) {
        std::uint64_t const one = 1;
        [[maybe_unused]] ssize_t const written = write(descriptor, &one, sizeof one);
    }
    errno = error;
}

void install() {
    struct sigaction action {};
    action.sa_handler = hold_back;
    action.sa_flags = SA_RESTART;
    for (std::size_t i = 0; i < all_ending_signals.size(); ++i) {
        sigaction(all_ending_signals[i], nullptr, &state().before[i]);
        if (state().before[i].sa_handler != SIG_IGN)
            sigaction(all_ending_signals[i], &action, nullptr);
    }
}

void restore() {
    for (std::size_t i = 0; i < all_ending_signals.size(); ++i)
        sigaction(all_ending_signals[i], &state().before[i], nullptr);
}

}  // namespace

HeldSignals::HeldSignals() {
    std::lock_guard<std::mutex> const lock(state().mutex);
    if (state().holders++ == 0)
        install();
}

HeldSignals::~HeldSignals() {
    int signal = 0;
    {
        std::lock_guard<std::mutex> const lock(state().mutex);
        if (--state().holders > 0)
            return;
        restore();
        signal = state().signal;
        forget_signal();
        state().first_ms = 0;
    }
    if (signal != 0)
        raise(signal);
}

void give_up_if_interrupted() {
    if (state().signal != 0)
        throw Interrupted();
}

void forget_signal() {
    int const error = errno;  // whoever unwinds has yet to say what went wrong
    state().signal = 0;
    std::uint64_t count = 0;
    if (int const descriptor = state().descriptor; descriptor >= 0) [[maybe_unused]]
        ssize_t const taken = read(descriptor, &count, sizeof count);
    errno = error;
}

int descriptor_of_signals() {
    std::lock_guard<std::mutex> const lock(state().mutex);
    if (state().descriptor < 0) {
        int const made = eventfd(state().signal != 0 ? 1 : 0, EFD_CLOEXEC | EFD_NONBLOCK);
        if (made < 0)
            throw HostError(std::string("no descriptor to watch for signals (") + std::strerror(errno) +
                            "), expected room for more open files");
        state().descriptor = made;
        if (state().signal != 0)  // it may have come in between
            eventfd_write(made, 1);
    }
    return state().descriptor;
}

/// Another thread of the parent may have had the lock; it is none of this process.
void let_signals_through() {
    State& child = state();
    new (&child.mutex) std::mutex;
    child.holders = 0;
    if (int const parents = child.descriptor.exchange(-1); parents >= 0)
        close(parents);
    struct sigaction action {};
    for (int const signal : all_ending_signals)
        if (sigaction(signal, nullptr, &action) == 0 && action.sa_handler == hold_back)
            std::signal(signal, SIG_DFL);
    child.first_ms = 0;
    if (int const signal = child.signal.exchange(0); signal != 0)
        raise(signal);
}

}  // namespace dataflow::processes
