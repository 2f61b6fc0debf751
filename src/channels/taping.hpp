#pragma once
#include <cstddef>
#include <deque>
#include <vector>

#include "channels/dataflow_accelerator.hpp"
#include "dataflow/run/figures/run_statistics.hpp"
#include "dataflow/run/replay/recorded_run.hpp"
#include "dataflow/run/replay/tape_writer.hpp"

namespace dataflow {

/// The results of the samples that a core has done.
std::vector<Counters> all_results(DataflowCore const& core);

/// Takes down what the processes of all cores do, sample by sample.
class Taping {
  public:
    /// Before simulation starts. `run` is complete after finish().
    Taping(DataflowAccelerator& accelerator, replay::RecordedRun& run);
    /// When nothing moves any more.
    void finish();

  private:
    /// What one core does. Its processes are at different samples.
    struct CoreTape {
        std::vector<timing::OperationLog> logs;  ///< by process, of the sample it is at
        std::vector<std::size_t> begun;          ///< by process: samples
        std::size_t done = 0;                    ///< samples that all processes have left
        std::deque<replay::SampleOperations> open;
        std::deque<std::size_t> left;  ///< by open sample: how many processes have left it
    };

    void tape_memory();
    void start(std::size_t core);
    void begin_sample(std::size_t core, std::size_t process);
    std::size_t take_log(std::size_t core, std::size_t process);
    void end_sample(std::size_t core, std::size_t process);
    void note_sites();
    void keep_unfinished();
    bool is_done() const;

    DataflowAccelerator& accelerator_;
    replay::RecordedRun& run_;
    std::vector<CoreTape> tapes_;  // by core
    std::size_t taking_part_ = 0;  // processes that the core has
    replay::TapeWriter writer_;
};

}  // namespace dataflow
