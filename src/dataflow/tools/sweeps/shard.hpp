#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "dataflow/tools/sweeps/manifest.hpp"
#include "dataflow/tools/sweeps/point_identity.hpp"
#include "dataflow/tools/sweeps/point_result.hpp"

namespace dataflow::sweeps {

/// Part `index` (from 1) of `count` parts.
struct Shard {
    std::size_t index = 1;
    std::size_t count = 1;
};

/// Which points a shard has, by their number. Every point that is the same as one before it is left out; of the others
/// each is in exactly one shard. Points that share a function stay together as far as the shards' equal sizes allow, so
/// that few functions are simulated by two shards.
std::vector<std::size_t> points_of_shard(std::vector<PointIdentity> const& points, Shard const& shard);

/// Results of several folders of one sweep.
struct Merged {
    Manifest manifest;
    Results results;
    std::vector<std::size_t> missing;  ///< points without a result
};

/// Reads the folders. A point that failed in one and not in another did not fail. Throws InputError for folders of
/// different sweeps, and if a point has different results.
Merged merged(std::vector<std::filesystem::path> const& folders);

/// Which of the manifest's points have no result.
std::vector<std::size_t> missing_points(Manifest const& manifest, Results const& results);

}  // namespace dataflow::sweeps
