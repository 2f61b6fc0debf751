#pragma once
#include <filesystem>
#include <vector>

#include "kernel/recording/recorded_core.hpp"
#include "kernel/recording/signal_filter.hpp"

namespace faster::recording {

/// What write_gtkwave_save() writes: the save file, and the tables that it names.
std::vector<std::filesystem::path> files_beside(std::filesystem::path const& vcd);

/// Writes the GTKWave save file of a value change dump: signals in groups, numbers in sensible radices, states and
/// stalls as text.
void write_gtkwave_save(std::filesystem::path const& vcd, Machine const& machine,
                        std::vector<RecordedCore> const& cores, SignalFilter const& filter);

}  // namespace faster::recording
