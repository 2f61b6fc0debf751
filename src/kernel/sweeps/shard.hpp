#pragma once
#include <cstddef>
#include <vector>

#include "kernel/sweeps/point_identity.hpp"

namespace faster::sweeps {

/// Part `index` (from 1) of `count` parts.
struct Shard {
    std::size_t index = 1;
    std::size_t count = 1;
};

/// Which points a shard has, by their number. Every point that is the same as one before it is left out; of the others
/// each is in exactly one shard. Points that share a function stay together as far as the shards' equal sizes allow, so
/// that few functions are simulated by two shards.
std::vector<std::size_t> points_of_shard(std::vector<PointIdentity> const& points, Shard const& shard);

}  // namespace faster::sweeps
