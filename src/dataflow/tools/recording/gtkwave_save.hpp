#pragma once
#include <filesystem>

#include "dataflow/tools/recording/recorded_window.hpp"
#include "dataflow/tools/recording/signal_filter.hpp"

namespace dataflow::recording {

/// Where GTKWave finds what values mean: in the waveform, or in tables of their own (.states.txt, .stalls.txt, ...),
/// which are written too.
enum class ValueNames { in_waveform, in_tables };

/// What is sure to be written beside a waveform: the save file, and tables. More tables, STEM.FIFO_FIELD.txt, belong to
/// FIFOs whose tokens have names for values.
std::vector<std::filesystem::path> files_beside(std::filesystem::path const& waveform, ValueNames names);

/// Writes a GTKWave save file (.gtkw) beside a waveform, with the same stem: signals in groups, numbers in sensible
/// radices, states and stalls as text. All names of files are relative, so that their folder can be moved. Errors:
/// InputError if one cannot be written.
void write_gtkwave_save(std::filesystem::path const& waveform, ValueNames names, Machine const& machine,
                        RecordedWindow const& window, SignalFilter const& filter);

}  // namespace dataflow::recording
