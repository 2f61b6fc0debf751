#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "channels/dataflow_accelerator.hpp"
#include "channels/simulate.hpp"
#include "dataflow/tools/recording/core_recorder.hpp"
#include "dataflow/tools/recording/memory_recorder.hpp"

namespace dataflow {

/// The recorders of all recordings of a run.
class Recordings {
  public:
    /// Attaches the recorders to the cores. `requests` must outlive this.
    Recordings(DataflowAccelerator& accelerator, std::vector<Recording> const& requests);
    /// The run is over: hands every recording over. `end`: the cycle after the last.
    void finish(Cycles end);

  private:
    struct Recorder {
        std::size_t request;
        std::size_t core;
        std::unique_ptr<recording::CoreRecorder> recorder;
    };
    void attach(std::size_t core, std::vector<recording::CoreRecorder*> const& recorders);
    void listen_to_memory();
    void forget_bursts();
    recording::RecordedCore recorded(Recorder& recorder, Cycles end);

    DataflowAccelerator& accelerator_;
    std::vector<Recording> const& requests_;
    std::vector<Recorder> recorders_;
    std::optional<recording::MemoryRecorder> memory_;
};

}  // namespace dataflow
