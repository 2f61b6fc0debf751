#pragma once
#include <cstddef>
#include <optional>

#include "dataflow/run/replay/recorded_run.hpp"
#include "dataflow/run/replay/sample_operations.hpp"
#include "dataflow/run/replay/tape_reader.hpp"

namespace dataflow::replay {

/// Reads samples of a run, which must outlive it, as operations, no phrases. Opens the tape when first asked.
class PlainReader {
  public:
    explicit PlainReader(RecordedRun const& run) : run_(run) {}
    SampleOperations read(std::size_t sample);

  private:
    RecordedRun const& run_;
    std::optional<TapeReader> tape_;
};

/// Appends what a process does for a sample. It may begin with a wait on from where the last sample ended: one wait
/// then, as the process itself would have said it.
void append_sample(std::vector<timing::Operation> const& operations, timing::OperationLog& log);

/// All samples of a core have been told.
void tell_end(timing::CoreTiming& core);

/// Tells a process, and whoever tapes it.
void tell_sample(std::vector<timing::Operation> const& operations, timing::ProcessTiming& process);

}  // namespace dataflow::replay
