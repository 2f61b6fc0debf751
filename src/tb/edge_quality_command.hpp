#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "tool/subcommand.hpp"

namespace faster {

/// `faster-sim edge-quality`.
struct EdgeQualityRequest {
    std::int64_t poses = 620;             ///< per class
    std::int64_t seed = 1;                ///< of the poses
    std::vector<std::string> classes;     ///< built-in objects; empty: all
    std::vector<std::string> algorithms;  ///< of accelerator.edge_map.algorithm; empty: all
    bool force = false;                   ///< however long it takes
    std::string out;                      ///< folder for quality.csv and pictures; empty: print only
};

/// Judges the edge maps of the algorithms. Throws InputError on bad input.
int edge_quality(EdgeQualityRequest const& request);

/// `edge-quality`.
Subcommand edge_quality_command();

}  // namespace faster
