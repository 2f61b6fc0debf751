#pragma once
#include <cstddef>
#include <functional>
#include <mutex>
#include <utility>

namespace dataflow {

/// Told after each piece of work how many are done; may be empty.
using TellProgress = std::function<void(std::size_t done, std::size_t all)>;

/// Counts pieces of work that several threads do, and tells of each, one at a time.
class CountedProgress {
  public:
    CountedProgress(std::size_t all, TellProgress tell) : all_(all), tell_(std::move(tell)) {}
    /// Pieces that become known on the way. Not while threads work.
    void expect(std::size_t more) { all_ += more; }
    void one_more() {
        std::lock_guard<std::mutex> const lock(mutex_);
        ++done_;
        if (tell_)
            tell_(done_, all_);
    }

  private:
    std::size_t all_;
    std::size_t done_ = 0;
    TellProgress tell_;
    std::mutex mutex_;
};

}  // namespace dataflow
