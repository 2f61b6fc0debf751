#pragma once
#include <array>
#include <vector>

#include "channels/token_tap.hpp"
#include "config/machine.hpp"
#include "recording/event_spool.hpp"
#include "timing/core_timing.hpp"

namespace faster::recording {

using Spools = std::array<EventSpool, module_count>;

/// Takes down what the processes of one core do, with the tokens they write.
class CoreCapture : public timing::StepObserver {
  public:
    /// Observes `core` from where it stands, its loops and the tokens in its FIFOs included. `taps`: by FifoId;
    /// they still hold the last `tokens_in_use` tokens that have been read.
    CoreCapture(timing::CoreTiming& core, std::vector<TokenTap> const& taps, std::size_t first_sample,
                std::uint64_t tokens_in_use, Spools& spools);

    /// Events after this cycle are not wanted.
    void set_end(Cycles last) { last_ = last; }

    void entered_loop(timing::ProcessTiming const& process, unsigned loop, Cycles cycle) override;
    void left_loop(timing::ProcessTiming const& process, Cycles cycle) override;
    void iterated(timing::ProcessTiming const& process, Cycles cycle, std::uint64_t first, std::uint64_t count,
                  Cycles stride) override;
    void stalled(timing::ProcessTiming const& process, unsigned port, Cycles from, Cycles until) override;
    void accessed(timing::ProcessTiming const& process, timing::Ports ports, Cycles cycle) override;
    void stamped(timing::ProcessTiming const& process, Cycles cycle) override;

  private:
    void put(timing::ProcessTiming const& process, Event const& event);
    void put_write(timing::ProcessTiming const& process, std::uint8_t fifo, std::uint64_t number, Cycles cycle);
    void put_read(timing::ProcessTiming const& process, std::uint8_t fifo, Cycles cycle);
    void take_down_state();
    void take_down_tokens(timing::ProcessTiming const& process);
    std::uint8_t fifo_at(timing::ProcessTiming const& process, unsigned port) const {
        return fifo_at_[process.index()][port];
    }

    timing::CoreTiming& core_;
    std::vector<TokenTap> const& taps_;
    std::size_t first_sample_;
    std::uint64_t tokens_in_use_;
    Spools& spools_;
    Cycles last_ = ~Cycles{0};
    std::array<std::vector<std::uint8_t>, module_count> fifo_at_;  // by process and port
    std::array<std::size_t, fifo_count> writers_{};                // number of the process
    std::array<std::uint8_t, module_count> first_loop_{};          // LoopId of each process's loop 0
};

}  // namespace faster::recording
