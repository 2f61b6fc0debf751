#pragma once
#include <cstddef>
#include <optional>
#include <vector>

namespace faster::grip {

/// The place of every value, 1 for the largest; equal values share the mean of theirs.
std::vector<double> ranks(std::vector<double> const& values);

/// Spearman's rank correlation of two lists of one length, -1 to 1. Nothing if one of them has fewer than two different
/// values.
std::optional<double> rank_correlation(std::vector<double> const& a, std::vector<double> const& b);

/// Where the largest value stands, the first of them; `values` is not empty.
std::size_t best_of(std::vector<double> const& values);

}  // namespace faster::grip
