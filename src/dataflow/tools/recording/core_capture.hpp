#pragma once
#include <deque>
#include <vector>

#include "dataflow/base/core_share.hpp"
#include "dataflow/core/machine/machine.hpp"
#include "dataflow/core/time/core_timing.hpp"
#include "dataflow/tools/recording/event_spool.hpp"
#include "dataflow/tools/recording/token_tap.hpp"

namespace dataflow::recording {

/// Takes down what the processes of one core do, with the tokens they write.
class CoreCapture : public timing::StepObserver {
  public:
    /// Observes `core` from where it stands. What can be seen of that comes first, as events up to its local times: the
    /// last stamps, the loops and their iterations, the tokens in its FIFOs. `taps`: by FIFO; they still hold the last
    /// `tokens_in_use` tokens that have been read. `spools`: of as many processes. `share`: its samples.
    CoreCapture(Machine const& machine, timing::CoreTiming& core, std::vector<TokenTap> const& taps, CoreShare share,
                std::uint64_t tokens_in_use, Spools& spools);

    /// Events after this cycle are not wanted.
    void set_end(Cycles last) { last_ = last; }

    void entered_loop(timing::ProcessTiming const& process, unsigned loop, Cycles cycle) override;
    void left_loop(timing::ProcessTiming const& process, Cycles cycle) override;
    void iterated(timing::ProcessTiming const& process, Cycles cycle, std::uint64_t first, std::uint64_t count,
                  Cycles stride) override;
    void stalled(timing::ProcessTiming const& process, unsigned port, Cycles from, Cycles until) override;
    void accessed(timing::ProcessTiming const& process, timing::Ports ports, Cycles cycle) override;
    void let_out(timing::ProcessTiming const& process, unsigned port, Cycles due, Cycles cycle) override;
    void stamped(timing::ProcessTiming const& process, Cycles cycle) override;
    /// Nothing more comes: tells what was told ahead of time.
    void finish();

  private:
    void put(timing::ProcessTiming const& process, Event const& event);
    void spool(std::size_t process, Event const& event);
    void put_late(timing::ProcessTiming const& process, std::uint32_t fifo, std::uint64_t number, Cycles due,
                  Cycles cycle);
    void put_stall(timing::ProcessTiming const& process, unsigned port, Cycles from, Cycles until);
    void tell_late(std::size_t process, Cycles until);
    std::vector<Event> write_of(std::uint32_t fifo, std::uint64_t number, Cycles cycle) const;
    void put_write(timing::ProcessTiming const& process, std::uint32_t fifo, std::uint64_t number, Cycles cycle);
    void put_read(timing::ProcessTiming const& process, std::uint32_t fifo, Cycles cycle);
    void put_stamp(timing::ProcessTiming const& process, std::size_t stamp);
    void put_sample(Event::Kind kind, std::size_t sample, Cycles cycle);
    void number_parts();
    void take_down_state();
    void take_down_samples(timing::ProcessTiming const& process);
    void take_down_loop(timing::ProcessTiming const& process);
    /// What happened before, and can still be seen.
    struct PastEvent {
        Cycles cycle;
        Event::Kind kind;  ///< read or write
        std::uint32_t fifo;
        std::uint64_t number;  ///< of its token
    };
    std::vector<PastEvent> past_accesses(timing::ProcessTiming const& process) const;
    void take_down_past(timing::ProcessTiming const& process);
    std::uint32_t fifo_at(timing::ProcessTiming const& process, unsigned port) const {
        return fifos_at_[process.index()][port];
    }

    Machine const& machine_;
    timing::CoreTiming& core_;
    std::vector<TokenTap> const& taps_;
    CoreShare share_;
    std::uint64_t tokens_in_use_;
    Spools& spools_;
    Cycles last_ = ~Cycles{0};
    std::vector<std::deque<Event>> late_;  ///< by process: events told ahead of time, in order
    // Numbers of parts of the machine.
    std::vector<std::vector<std::uint32_t>> fifos_at_;  // by process and port
    std::vector<std::vector<std::uint32_t>> loops_at_;  // by process and number of the loop in it
    std::vector<std::size_t> writers_;                  // by FIFO: the process that writes it
};

}  // namespace dataflow::recording
