#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "faster/dataflow_names.hpp"
#include "poses/judging/evaluation.hpp"

namespace faster {

/// `faster-sim evaluate`.
struct EvaluateRequest {
    std::vector<std::string> files;   ///< of results, one per method; the last is the dataset
    std::vector<std::string> models;  ///< folders to look for meshes in first
    std::string models_in;            ///< unit of the meshes, m or mm; empty: as the dataset's kind has it
    std::string split;                ///< of the dataset; empty: `test`, or the only one
    std::string out;                  ///< folder; empty: none
    double visible_from = 0;          ///< only instances of which this share is visible
    double vsd_delta_mm = 15;         ///< of VSD
    std::int64_t seed = 1;            ///< of the bootstrap
    std::int64_t replicates = 1000;   ///< of the bootstrap
    std::int64_t jobs = 0;            ///< threads; 0: the host's cores
    bool force = false;               ///< however long it takes
};

/// Judges estimated poses, prints a table, and writes tables, plots and a page. Throws InputError on bad input.
poses::Evaluation evaluate(EvaluateRequest const& request);

}  // namespace faster
