#pragma once
#include <memory>
#include <vector>

#include "modules/accelerator.hpp"
#include "tb/simulation/simulate.hpp"

namespace faster {

/// The recorders of all recordings of a run.
class Recordings {
  public:
    /// Attaches the recorders to the cores. `requests` must outlive this.
    Recordings(Accelerator& accelerator, std::vector<Recording> const& requests);
    /// The run is over: hands every recording over. `end`: the cycle after the last.
    void finish(Cycles end);

  private:
    struct Recorder {
        std::size_t request;
        std::size_t core;
        std::unique_ptr<recording::CoreRecorder> recorder;
    };
    recording::RecordedCore recorded(Recorder& recorder, Cycles end) const;

    Accelerator& accelerator_;
    std::vector<Recording> const& requests_;
    std::vector<Recorder> recorders_;
};

}  // namespace faster
