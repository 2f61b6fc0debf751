#pragma once
#include <filesystem>

#include "dataflow/tools/sweeps/sweep.hpp"

namespace dataflow::sweeps {

/// More are taken for a mistake in the file.
constexpr std::size_t most_points = 100'000;

/// Reads a sweep file (docs/formats.md, "Sweep files"). Relative paths in it are relative to its folder. Throws
/// InputError for anything it should not have: file, line, key, what was found and what was expected. Whether each
/// point is a valid configuration is not looked at, see Sweep::configuration().
Sweep read_sweep_file(std::filesystem::path const& path);

}  // namespace dataflow::sweeps
