#pragma once
#include <filesystem>

#include "dataflow/tools/compare/run_record.hpp"

namespace dataflow::runs {

/// Reads back what `faster-sim run --out FOLDER` wrote. Figures come from summary.json, samples from samples.csv;
/// fifos.csv and loops.csv have to agree with the summary. Throws InputError that names file and line or key if a file
/// is missing, cut off, of another format or version, or contradicts another.
RunRecord read_run(std::filesystem::path const& folder);

/// A run whose summary.json and samples are at hand. `name` stands for its folder.
RunRecord run_record(std::string const& name, std::string const& summary, std::vector<SampleStatistics> samples);

}  // namespace dataflow::runs
