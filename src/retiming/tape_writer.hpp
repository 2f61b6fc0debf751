#pragma once
#include <array>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "retiming/operation_tape.hpp"

namespace faster::retiming {

/// Puts samples on a tape from a thread of its own, so that the run that is recorded need not wait for it.
class TapeWriter {
  public:
    /// `processes` of a core.
    TapeWriter(OperationTape& tape, std::size_t processes);
    ~TapeWriter();
    TapeWriter(TapeWriter const&) = delete;
    TapeWriter& operator=(TapeWriter const&) = delete;

    /// The operations as the processes told them. Waits if the thread is far behind.
    void put(std::size_t sample, SampleOperations operations);
    /// All is on the tape. Throws what went wrong meanwhile.
    void finish();
    /// Bits of the ports that a process accessed outside loops; after finish().
    std::uint32_t step_ports(std::size_t process) const { return step_ports_[process]; }

  private:
    void work();
    void write(std::size_t sample, SampleOperations operations);
    void stop();

    OperationTape& tape_;
    std::vector<std::uint32_t> step_ports_;
    std::deque<std::pair<std::size_t, SampleOperations>> waiting_;
    bool stops_ = false;
    std::exception_ptr error_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::thread thread_;
};

}  // namespace faster::retiming
