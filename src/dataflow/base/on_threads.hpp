#pragma once
#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace dataflow {

/// How many jobs at once, where 0 (or less) means as many as the host has cores.
template <class Number> std::size_t jobs_or_host_cores(Number jobs) {
    return jobs > 0 ? static_cast<std::size_t>(jobs) : std::max(1U, std::thread::hardware_concurrency());
}

/// work(0), ..., work(count - 1) on up to `jobs` threads, or as many as the system has, each of which takes the next
/// number when it has done one. Throws what one of them threw.
inline void on_threads(std::size_t count, std::size_t jobs, std::function<void(std::size_t i)> const& work) {
    std::atomic<std::size_t> next{0};
    std::exception_ptr error;
    std::mutex mutex;
    auto const take = [&] {
        try {
            for (std::size_t i = next++; i < count; i = next++)
                work(i);
        } catch (...) {
            next = count;
            std::lock_guard<std::mutex> const lock(mutex);
            error = std::current_exception();
        }
    };
    std::vector<std::thread> others;
    try {
        for (std::size_t i = 1; i < std::min(jobs, count); ++i)
            others.emplace_back(take);
    } catch (std::system_error const&) {  // no more of them: fewer do
    }
    take();
    for (std::thread& other : others)
        other.join();
    if (error)
        std::rethrow_exception(error);
}

}  // namespace dataflow
