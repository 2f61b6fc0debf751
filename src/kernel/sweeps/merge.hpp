#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "kernel/sweeps/journal.hpp"
#include "kernel/sweeps/manifest.hpp"

namespace faster::sweeps {

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

}  // namespace faster::sweeps
