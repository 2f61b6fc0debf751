#include "poses/judging/matching.hpp"

#include <limits>

namespace faster::poses {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

class Matching {
  public:
    Matching(PairErrors const& errors, std::size_t truths)
        : errors_(errors), is_used_(errors.size(), false), matched_(truths, infinite) {}

    void match(double limit) {
        for (std::size_t e = 0; e < errors_.size(); ++e) {
            if (!is_used_[e])
                take_nearest(e, limit);
        }
    }
    std::vector<double> const& errors() const { return matched_; }

  private:
    void take_nearest(std::size_t e, double limit) {
        std::size_t nearest = matched_.size();
        for (std::size_t g = 0; g < matched_.size(); ++g) {
            double const least = nearest < matched_.size() ? errors_[e][nearest] : limit;
            if (matched_[g] == infinite && errors_[e][g] < least)
                nearest = g;
        }
        if (nearest < matched_.size()) {
            matched_[nearest] = errors_[e][nearest];
            is_used_[e] = true;
        }
    }

    PairErrors const& errors_;
    std::vector<bool> is_used_;
    std::vector<double> matched_;
};

}  // namespace

std::vector<double> matched_below(PairErrors const& errors, std::size_t truths, double limit) {
    Matching matching(errors, truths);
    matching.match(limit);
    return matching.errors();
}

std::vector<double> matched(PairErrors const& errors, std::size_t truths, double limit) {
    Matching matching(errors, truths);
    matching.match(limit);
    matching.match(infinite);
    return matching.errors();
}

}  // namespace faster::poses
