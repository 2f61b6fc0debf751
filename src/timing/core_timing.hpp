#pragma once
#include <deque>
#include <string>
#include <vector>

#include "timing/process_timing.hpp"
#include "timing/steady_state.hpp"

namespace faster::timing {

/// One process that cannot go on, and why.
struct Wait {
    std::string process;
    std::string position;
    std::string fifo;
    bool to_write = false;  ///< the FIFO is full; otherwise empty
    std::uint64_t occupancy = 0;
    std::uint64_t capacity = 0;
    Cycles since = 0;   ///< local time of the process
    std::string other;  ///< the process at the other end of the FIFO
};

/// The FIFOs and processes of one raster core, and the calculation of their times. Which process goes first never
/// matters: an access gets its cycle once everything that decides it is known.
class CoreTiming {
  public:
    FifoTiming& add_fifo(FifoShape shape);
    ProcessTiming& add_process(std::string name);

    /// Gives cycles to all logged operations that can have them.
    void resolve();

    std::deque<FifoTiming> const& fifos() const { return fifos_; }
    std::deque<ProcessTiming> const& processes() const { return processes_; }

    /// The processes with operations left, in order; call after resolve(). Empty unless the core is stuck.
    std::vector<Wait> waits();

  private:
    struct Ends {
        int writer = -1;
        int reader = -1;
    };
    void connect();
    std::size_t number_of(FifoTiming const& fifo) const;

    std::deque<FifoTiming> fifos_;  // deque: references stay valid
    std::deque<ProcessTiming> processes_;
    std::vector<Ends> ends_;  // by FIFO
    SteadyState steady_state_;
};

}  // namespace faster::timing
