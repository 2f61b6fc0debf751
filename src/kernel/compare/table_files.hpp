#pragma once
#include <filesystem>
#include <vector>

#include "kernel/compare/json_section.hpp"
#include "kernel/compare/run_record.hpp"

namespace faster::runs {

/// The rows of a samples.csv, which must fit the run: numbered without gaps, as many as `samples`, on its cores, and
/// within its cycles. Throws InputError.
std::vector<SampleStatistics> read_samples(std::filesystem::path const& path, RunRecord const& run,
                                           std::uint64_t samples);

/// fifos.csv and loops.csv tell again what stands in the summary. If they tell something else (a file cut off, edited,
/// or of another run), nobody can say which is right: InputError. Loops that loops.csv leaves out for every core are
/// fine.
void check_fifos(std::filesystem::path const& path, RunRecord const& run);
void check_loops(std::filesystem::path const& path, RunRecord const& run);

}  // namespace faster::runs
