#include "poses/judging/matching.hpp"

#include <limits>
#include <optional>

namespace faster::poses {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Estimates that are left take true poses that are left, nearer than the limit.
void match(PairErrors const& errors, double limit, std::vector<bool>& is_used, std::vector<double>& matched) {
    for (std::size_t e = 0; e < errors.size(); ++e) {
        std::optional<std::size_t> nearest;
        for (std::size_t g = 0; g < matched.size() && !is_used[e]; ++g) {
            if (matched[g] == infinite && errors[e][g] < (nearest ? errors[e][*nearest] : limit))
                nearest = g;
        }
        if (nearest) {
            matched[*nearest] = errors[e][*nearest];
            is_used[e] = true;
        }
    }
}

}  // namespace

std::vector<double> matched_below(PairErrors const& errors, std::size_t truths, double limit) {
    std::vector<bool> is_used(errors.size(), false);
    std::vector<double> matched(truths, infinite);
    match(errors, limit, is_used, matched);
    return matched;
}

std::vector<double> matched(PairErrors const& errors, std::size_t truths, double limit) {
    std::vector<bool> is_used(errors.size(), false);
    std::vector<double> matched(truths, infinite);
    match(errors, limit, is_used, matched);
    match(errors, infinite, is_used, matched);
    return matched;
}

}  // namespace faster::poses
