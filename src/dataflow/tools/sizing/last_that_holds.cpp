#include "dataflow/tools/sizing/last_that_holds.hpp"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <mutex>
#include <vector>

#include "dataflow/base/on_threads.hpp"

namespace dataflow::sizing {

namespace {

/// The number of the first of 0 .. count - 1 for which `holds` is false, as it is from there on.
std::size_t first_without(std::size_t count, std::function<bool(std::size_t)> const& holds) {
    std::size_t first = 0;
    for (std::size_t end = count; first < end;) {
        std::size_t const middle = first + (end - first) / 2;
        holds(middle) ? first = middle + 1 : end = middle;
    }
    return first;
}

/// What several workers know together: it holds for `yes`, and not for `no`.
class Bisection {
  public:
    Bisection(std::size_t yes, std::size_t no, Monotone const& monotone)
        : monotone_(monotone), yes_(yes), no_(no), near_{yes + 1, yes + 1 + std::max<std::size_t>(1, open() / 8)} {}

    std::size_t yes() const { return yes_; }

    /// Until nothing is left to be tried.
    void work() {
        std::unique_lock<std::mutex> lock(mutex_);
        while (open() > 0) {
            std::optional<std::size_t> const number = next();
            if (number)
                attempt(*number, lock);
            else
                is_narrower_.wait(lock);
        }
    }

  private:
    std::size_t open() const { return no_ - yes_ - 1; }
    bool is_open(std::size_t number) const { return number > yes_ && number < no_; }

    void attempt(std::size_t number, std::unique_lock<std::mutex>& lock) {
        tried_.push_back(number);
        lock.unlock();
        std::optional<bool> held;
        try {
            held = monotone_.holds(number, [this, number] {
                std::lock_guard<std::mutex> const inner(mutex_);
                return !is_open(number);
            });
        } catch (...) {
            lock.lock();
            no_ = yes_ + 1;  // nobody needs to go on
            is_narrower_.notify_all();
            throw;
        }
        lock.lock();
        tried_.erase(std::find(tried_.begin(), tried_.end(), number));
        if (held && is_open(number))
            (*held ? yes_ : no_) = number;
        is_narrower_.notify_all();
    }

    /// Nothing if all are being tried.
    std::optional<std::size_t> next() {
        while (!near_.empty()) {
            std::size_t const number = near_.front();
            near_.erase(near_.begin());
            if (is_open(number))
                return number;
        }
        std::vector<std::size_t> known{yes_, no_};
        std::copy_if(tried_.begin(), tried_.end(), std::back_inserter(known),
                     [this](std::size_t number) { return is_open(number); });
        std::sort(known.begin(), known.end());
        std::size_t begin = yes_;
        std::size_t widest = 0;
        for (std::size_t i = 1; i < known.size(); ++i)
            if (known[i] - known[i - 1] > widest) {
                begin = known[i - 1];
                widest = known[i] - begin;
            }
        return widest > 1 ? std::optional(begin + widest / 2) : std::nullopt;
    }

    Monotone const& monotone_;
    std::mutex mutex_;
    std::condition_variable is_narrower_;
    std::size_t yes_;
    std::size_t no_;
    std::vector<std::size_t> near_;
    std::vector<std::size_t> tried_;
};

}  // namespace

std::size_t last_that_holds(std::size_t count, unsigned jobs, Monotone const& monotone) {
    auto const known_or = [&](bool otherwise) {
        return first_without(count, [&](std::size_t i) { return monotone.is_known_to_hold(i).value_or(otherwise); });
    };
    std::size_t const known = known_or(false);
    std::size_t const yes = known == 0 ? 0 : known - 1;
    std::size_t const no = std::max(known_or(true), yes + 1);
    Bisection bisection(yes, no, monotone);
    std::size_t const workers = std::min<std::size_t>(std::max(1U, jobs), std::max<std::size_t>(1, no - yes - 1));
    on_threads(workers, workers, [&](std::size_t) { bisection.work(); });
    return bisection.yes();
}

std::size_t last_before_failing(std::size_t count, unsigned jobs, Monotone::Holds const& holds) {
    std::size_t yes = 0;
    std::size_t no = count;
    for (bool is_first = true; no - yes > 1; is_first = false) {
        std::size_t const open = no - yes - 1;
        std::size_t const step = is_first ? std::max<std::size_t>(1, open / 8) : (open + 2) / 3;
        std::size_t const near = is_first ? yes + 1 : yes + step;
        std::size_t const far = std::min(no - 1, near + step);
        std::atomic<bool> holds_far = false;
        bool holds_near = false;
        on_threads(2, jobs, [&](std::size_t i) {
            if (i == 0)
                holds_far = holds(far, [] { return false; }).value();
            else if (far != near && !holds_far)
                holds_near = holds(near, [&holds_far] { return holds_far.load(); }).value_or(false);
        });
        if (holds_far)
            yes = far;
        else if (holds_near)
            yes = near, no = far;
        else
            no = near;
    }
    return yes;
}

}  // namespace dataflow::sizing
