#pragma once
#include <optional>
#include <yaml-cpp/yaml.h>

#include "dataflow/tools/sweeps/key_cells.hpp"
#include "dataflow/tools/sweeps/sweep.hpp"

namespace dataflow::sweeps {

/// An item of `dimensions`; one of
///   {key: KEY, values: [...]}                     the values as listed
///   {key: KEY, range: [FIRST, LAST], step: STEP}  FIRST, FIRST + STEP, ... up to LAST
///   {overlay: NAME, files: [...]}                 configuration files over the base
///   {zip: {KEY: [...], KEY: [...]}}               row by row
///   {random: {KEY: DRAW, ...}, count: N, seed: S} independent draws
///   {seeds: [KEY, ...], count: N, first: S}       the same seed for all keys
/// What is wrong is added to the faults of `cells`; then there is no dimension.
std::optional<Dimension> read_dimension(YAML::Node const& item, int line, KeyCells const& cells);

}  // namespace dataflow::sweeps
