#pragma once
#include <deque>
#include <vector>

#include "modules/accelerator.hpp"
#include "retiming/recorded_run.hpp"
#include "retiming/tape_writer.hpp"

namespace faster {

/// Takes down what the processes of all cores do, sample by sample.
class Taping {
  public:
    /// Before simulation starts. `run` is complete after finish().
    Taping(Accelerator& accelerator, retiming::RecordedRun& run);
    /// When all samples are scored.
    void finish();

  private:
    /// What one core does. Its processes are at different samples.
    struct CoreTape {
        std::vector<timing::OperationLog> logs;  ///< by process, of the sample it is at
        std::vector<std::size_t> begun;          ///< by process: samples
        std::size_t done = 0;                    ///< samples that all processes have left
        std::deque<retiming::SampleOperations> open;
        std::deque<std::size_t> left;  ///< by open sample: how many processes have left it
    };

    void start(std::size_t core);
    void begin_sample(std::size_t core, std::size_t process);
    void end_sample(std::size_t core, std::size_t process);
    void note_sites();

    Accelerator& accelerator_;
    retiming::RecordedRun& run_;
    std::vector<CoreTape> tapes_;  // by core
    std::size_t taking_part_ = 0;  // processes that the core has
    retiming::TapeWriter writer_;
};

}  // namespace faster
