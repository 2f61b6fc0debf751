#pragma once
#include <cstddef>
#include <deque>
#include <optional>
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
    /// Who works out the time: the cores, as always; or, from what is taken down, another thread, while the processes
    /// go on.
    enum class Timing { by_cores, from_tape };

    /// Before simulation starts. `run` is complete after finish().
    Taping(DataflowAccelerator& accelerator, replay::RecordedRun& run, Timing timing);
    /// When nothing moves any more.
    void finish();
    Timing timing() const { return timing_; }
    /// The figures worked out from the tape, after finish(). None if the run got stuck: the cores have been told what
    /// they did then, and can say why.
    std::optional<RunStatistics> statistics();

  private:
    /// What one core does. Its processes are at different samples.
    struct CoreTape {
        std::vector<timing::OperationLog> logs;  ///< by process, of the sample it is at, where cores keep the time
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
    timing::OperationLog& log_of(std::size_t core, std::size_t process);
    void note_sites();
    void keep_unfinished();
    bool is_done() const;
    void tell_cores();

    DataflowAccelerator& accelerator_;
    Timing timing_;
    replay::RecordedRun& run_;
    std::vector<CoreTape> tapes_;  // by core
    std::size_t taking_part_ = 0;  // processes that the core has
    replay::TapeWriter writer_;
};

}  // namespace dataflow
