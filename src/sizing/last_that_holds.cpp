#include "sizing/last_that_holds.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "common/on_threads.hpp"

namespace faster::sizing {

namespace {

using Numbers = std::vector<std::size_t>;

class BracketSearch {
  public:
    BracketSearch(std::size_t count, unsigned jobs, Monotone const& monotone)
        : count_(count), jobs_(std::max(1U, jobs)), monotone_(monotone) {}

    std::size_t last() {
        std::size_t const known = first_known_without(false);
        yes_ = known == 0 ? 0 : known - 1;
        no_ = first_known_without(true);
        note_margin(yes_);
        if (no_ < count_)
            note_margin(no_);
        bool was_good = true;
        for (bool is_first = true; open() > 0; is_first = false) {
            std::size_t const before = open();
            Numbers numbers = was_good ? around_the_expected() : Numbers{};
            if (numbers.empty())
                numbers = is_first ? near_the_first() : evenly();
            try_out(numbers);
            was_good = is_first || !was_good || 2 * open() <= before;
        }
        return yes_;
    }

  private:
    std::size_t open() const { return no_ - yes_ - 1; }

    /// The first for which it is known not to hold, unknown ones counting as `unknown`; count_ if there is none.
    std::size_t first_known_without(bool unknown) const {
        return first_without(0, count_, [&](std::size_t i) { return monotone_.is_known_to_hold(i).value_or(unknown); });
    }

    static std::size_t first_without(std::size_t first, std::size_t end,
                                     std::function<bool(std::size_t)> const& holds) {
        while (first < end) {
            std::size_t const middle = first + (end - first) / 2;
            holds(middle) ? first = middle + 1 : end = middle;
        }
        return first;
    }

    void note_margin(std::size_t number) {
        if (std::optional<double> const margin = monotone_.known_margin(number))
            margins_[number] = *margin;
    }

    Numbers evenly() const {
        Numbers numbers;
        std::size_t const probes = std::min<std::size_t>(jobs_, open());
        for (std::size_t i = 1; i <= probes; ++i)
            numbers.push_back(yes_ + (no_ - yes_) * i / (probes + 1));
        return numbers;
    }

    Numbers near_the_first() const {
        Numbers numbers{yes_ + 1};
        std::size_t const step = std::max<std::size_t>(1, open() / 8);
        for (std::size_t i = 1; i < jobs_ && yes_ + 1 + i * step < no_; ++i)
            numbers.push_back(yes_ + 1 + i * step);
        return numbers;
    }

    using Point = std::map<std::size_t, double>::const_iterator;

    /// Up to three points at one end of the bracket, the nearest first.
    std::vector<std::size_t> points_at(Point end, bool downwards) const {
        std::vector<std::size_t> points;
        while (points.size() < 3 && end != margins_.end()) {
            points.push_back(end->first);
            if (downwards && end == margins_.begin())
                break;
            end = downwards ? std::prev(end) : std::next(end);
        }
        return points;
    }

    double slope(std::size_t one, std::size_t other) const {
        return (margins_.at(other) - margins_.at(one)) / (monotone_.place(other) - monotone_.place(one));
    }

    /// Where the parabola through three points, or the line through two, comes nearest to no margin.
    std::optional<double> end_of_margin(std::vector<std::size_t> const& points) const {
        if (points.size() < 2 || slope(points[0], points[1]) >= 0)
            return std::nullopt;
        double const at = monotone_.place(points[0]);
        double const margin = margins_.at(points[0]);
        double const line = slope(points[0], points[1]);
        if (points.size() < 3)
            return at - margin / line;
        double const bend = (slope(points[1], points[2]) - line) / (monotone_.place(points[2]) - at);
        double const tangent = line + bend * (at - monotone_.place(points[1]));
        double const square = tangent * tangent - 4 * bend * margin;
        if (tangent >= 0)
            return at - margin / line;
        return square > 0 ? at - 2 * margin / (tangent - std::sqrt(square)) : at - 2 * margin / tangent;
    }

    /// The last that holds, if what is known of the steeper side goes on.
    std::optional<std::size_t> expected_last() const {
        auto const no = margins_.lower_bound(no_);
        if (no == margins_.begin() || std::prev(no)->first != yes_)
            return std::nullopt;
        std::vector<std::size_t> const above = points_at(std::prev(no), true);
        std::vector<std::size_t> const below = points_at(no, false);
        auto const steepness = [this](std::vector<std::size_t> const& points) {
            return points.size() < 2 ? 0.0 : -slope(points[0], points[1]);
        };
        bool const from_below = steepness(below) > steepness(above);
        std::optional<double> end = end_of_margin(from_below ? below : above);
        if (!end && !below.empty())
            end = end_of_margin({yes_, below.front()});
        if (!end)
            return std::nullopt;
        return first_without(yes_ + 1, no_, [&](std::size_t i) { return monotone_.place(i) <= *end; }) - 1;
    }

    /// On both sides of where the last is expected, the closer the less that differs from what was expected before.
    Numbers around_the_expected() {
        std::optional<std::size_t> const last = expected_last();
        if (!last)
            return {};
        std::size_t const doubt = expected_ ? std::max(*expected_, *last) - std::min(*expected_, *last) : open() / 8;
        expected_ = last;
        std::size_t const low = std::max(yes_ + 1, *last - std::min(*last, doubt / 2));
        std::size_t const high = std::min(no_ - 1, *last + 1 + doubt / 2);
        if (jobs_ == 1 || low >= high)
            return {jobs_ == 1 ? std::min(std::max(*last, yes_ + 1), no_ - 1) : std::min(low, no_ - 1)};
        return {low, high};
    }

    void try_out(Numbers const& numbers) {
        std::vector<char> held(numbers.size());
        on_threads(numbers.size(), jobs_, [&](std::size_t i) { held[i] = monotone_.holds(numbers[i]) ? 1 : 0; });
        auto const passed = static_cast<std::size_t>(std::find(held.begin(), held.end(), 0) - held.begin());
        if (passed < numbers.size())
            no_ = numbers[passed];
        if (passed > 0)
            yes_ = numbers[passed - 1];
        for (std::size_t const number : numbers)
            note_margin(number);
    }

    std::size_t count_;
    unsigned jobs_;
    Monotone const& monotone_;
    std::size_t yes_ = 0;  ///< it holds
    std::size_t no_ = 0;   ///< it does not
    std::map<std::size_t, double> margins_;
    std::optional<std::size_t> expected_;
};

}  // namespace

std::size_t last_that_holds(std::size_t count, unsigned jobs, Monotone const& monotone) {
    return BracketSearch(count, jobs, monotone).last();
}

}  // namespace faster::sizing
