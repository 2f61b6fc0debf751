#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "dataflow/base/input_error.hpp"
#include "dataflow/run/config/load_config.hpp"

namespace dataflow::sweeps {

/// What a point has in one column.
struct Cell {
    std::string text;            ///< for people and tables: the value as written
    std::string setting;         ///< "KEY=VALUE"; empty for an overlay
    std::filesystem::path file;  ///< of an overlay; empty otherwise
};

/// Something that is varied: the points have its rows, one after the other.
struct Dimension {
    std::vector<std::string> columns;  ///< keys, or the name of an overlay
    std::vector<std::vector<Cell>> rows;
};

/// A sweep file (docs/sweeps.md): every combination of the rows of its dimensions is a point. The last dimension
/// changes quickest.
struct Sweep {
    std::string file;                   ///< as given
    std::filesystem::path base;         ///< configuration file; empty: the defaults
    std::vector<std::string> settings;  ///< "KEY=VALUE" for all points
    std::vector<Dimension> dimensions;

    std::size_t points() const;
    std::vector<std::string> columns() const;
    /// What a point has in the columns.
    std::vector<Cell> cells(std::size_t point) const;
    /// The texts of cells().
    std::vector<std::string> values(std::size_t point) const;
    /// As `faster-sim run BASE --set ...` would resolve it: the base, then overlays, then settings, then the point's
    /// keys. Throws InputError, naming the point, if it is no valid configuration.
    LoadedConfig configuration(std::size_t point) const;
    /// An error of a point, named.
    InputError error_of(std::size_t point, InputError const& error) const;
};

/// Names a point in messages: "point 3 (accelerator.clock_mhz=250)".
std::string name_of_point(std::size_t point, std::vector<std::string> const& columns,
                          std::vector<std::string> const& values);

}  // namespace dataflow::sweeps
