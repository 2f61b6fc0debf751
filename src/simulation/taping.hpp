#pragma once
#include <vector>

#include "modules/accelerator.hpp"
#include "retiming/recorded_run.hpp"

namespace faster {

/// Takes down what the processes of all cores do, a round per sample.
class Taping {
  public:
    /// Before simulation starts. `run` is complete after finish().
    Taping(Accelerator& accelerator, retiming::RecordedRun& run);
    void finish();

  private:
    using Logs = std::vector<timing::OperationLog>;  // by process

    void start(std::size_t core);
    void take_round(std::size_t core);

    Accelerator& accelerator_;
    retiming::RecordedRun& run_;
    std::vector<Logs> logs_;  // by core
};

}  // namespace faster
