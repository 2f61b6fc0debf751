#include "sizing/on_threads.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace faster::sizing {

void on_threads(std::size_t count, unsigned jobs, std::function<void(std::size_t)> const& work) {
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
    for (std::size_t i = 1; i < std::min<std::size_t>(jobs, count); ++i)
        others.emplace_back(take);
    take();
    for (std::thread& other : others)
        other.join();
    if (error)
        std::rethrow_exception(error);
}

}  // namespace faster::sizing
