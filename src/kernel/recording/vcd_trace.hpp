#pragma once
#include <filesystem>
#include <vector>

#include "kernel/recording/vcd_core.hpp"

namespace faster::recording {

/// Writes what was recorded of some cores of a machine as a value change dump, and beside it, with the same stem, a
/// GTKWave save file (.gtkw) and its translation of states and stalls (.states.txt, .stalls.txt).
/// Errors: InputError if a file cannot be written.
void write_vcd(std::filesystem::path const& file, Machine const& machine, std::vector<RecordedCore> const& cores,
               SignalFilter const& filter);

}  // namespace faster::recording
