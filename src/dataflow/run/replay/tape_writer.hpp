#pragma once
#include <cstddef>
#include <memory>
#include <vector>

#include "dataflow/base/worker.hpp"
#include "dataflow/run/replay/recorded_run.hpp"
#include "dataflow/run/replay/sample_cutter.hpp"

namespace dataflow::replay {

/// Puts samples on a run's tape from a thread of its own, so that what is recorded need not wait for it.
class TapeWriter {
  public:
    /// For machines with that lead, and so many processes in a core. The run's blueprint must be there when the first
    /// sample is.
    TapeWriter(RecordedRun& run, timing::Lead const& lead, std::size_t processes);
    TapeWriter(TapeWriter const&) = delete;
    TapeWriter& operator=(TapeWriter const&) = delete;
    ~TapeWriter() = default;

    /// The operations as the processes told them. Waits if the thread is far behind.
    void put(std::size_t sample, SampleOperations operations);
    /// All is on the tape. Throws what went wrong meanwhile.
    void finish();
    /// The ports that a process accessed outside loops; after finish().
    timing::Ports step_ports(std::size_t process) const { return step_ports_[process]; }

  private:
    void write(std::size_t sample, SampleOperations operations);

    RecordedRun& run_;
    timing::Lead lead_;
    std::vector<timing::Ports> step_ports_;
    std::unique_ptr<SampleCutter> cutter_;
    std::unique_ptr<Worker> thread_;  // last: it uses all others
};

}  // namespace dataflow::replay
