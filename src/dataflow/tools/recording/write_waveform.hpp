#pragma once
#include <functional>

#include "dataflow/tools/recording/recorded_window.hpp"
#include "dataflow/tools/recording/signal_filter.hpp"
#include "dataflow/tools/recording/waveform.hpp"

namespace dataflow::recording {

/// Told now and then how many cycles are written, of how many.
using WritingProgress = std::function<void(Cycles done, Cycles all)>;

/// Writes what was recorded of some cores of a machine, in all formats at once, and finishes the files.
/// Errors: InputError if a file cannot be written.
void write_waveform(WaveformFiles const& files, Machine const& machine, RecordedWindow const& window,
                    SignalFilter const& filter, WritingProgress const& progress = {});

}  // namespace dataflow::recording
