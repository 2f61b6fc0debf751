#include "poses/grip/rank_correlation.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace faster::grip {

std::vector<double> ranks(std::vector<double> const& values) {
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&values](std::size_t a, std::size_t b) { return values[a] > values[b]; });
    std::vector<double> ranks(values.size());
    for (std::size_t first = 0; first < order.size();) {
        std::size_t end = first + 1;
        while (end < order.size() && values[order[end]] == values[order[first]])
            ++end;
        for (std::size_t i = first; i < end; ++i)
            ranks[order[i]] = static_cast<double>(first + 1 + end) / 2;
        first = end;
    }
    return ranks;
}

std::optional<double> rank_correlation(std::vector<double> const& a, std::vector<double> const& b) {
    std::vector<double> const ranks_a = ranks(a);
    std::vector<double> const ranks_b = ranks(b);
    double const mean = (static_cast<double>(a.size()) + 1) / 2;
    double products = 0, squares_a = 0, squares_b = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        products += (ranks_a[i] - mean) * (ranks_b[i] - mean);
        squares_a += (ranks_a[i] - mean) * (ranks_a[i] - mean);
        squares_b += (ranks_b[i] - mean) * (ranks_b[i] - mean);
    }
    if (squares_a == 0 || squares_b == 0)
        return std::nullopt;
    return products / std::sqrt(squares_a * squares_b);
}

std::size_t best_of(std::vector<double> const& values) {
    return static_cast<std::size_t>(std::max_element(values.begin(), values.end()) - values.begin());
}

}  // namespace faster::grip
