#pragma once
#include <cstdint>

#include "dataflow/core/time/process_timing.hpp"

namespace dataflow::replay {

/// Whether a process can do operations one after the other: what is read from a file may say anything.
class OperationCheck {
  public:
    static constexpr std::size_t unknown_loop = ~std::size_t{0};
    /// What the operations so far left.
    struct State {
        bool in_loop = false;
        bool stamped = false;             ///< once per sample at most
        std::int64_t setups = 0;          ///< begun and not awaited
        std::size_t loop = unknown_loop;  ///< the last that it entered
    };

    explicit OperationCheck(timing::ProcessTiming const& process) : process_(&process) {}

    std::size_t port_count() const { return process_->port_count(); }

    bool accepts(timing::Operation const& operation);
    /// All it entered it left, and all it began it awaited.
    bool is_done() const { return !state_.in_loop && state_.setups == 0; }

    State const& state() const { return state_; }
    /// Goes on from there.
    void set_state(State const& state) { state_ = state; }
    /// Whether a process is in a loop where it does an operation.
    static bool is_in_loop_at(timing::Operation const& operation);

  private:
    bool has_ports(timing::Ports::Number ports) const;
    bool can_iterate(timing::Ports::Number ports) const;
    bool accepts_iterations(timing::Operation const& operation) const;
    bool accepts_mix(timing::Operation const& operation) const;
    bool accepts_wait(timing::Operation const& operation);
    bool accepts_choice(timing::Operation const& operation) const;
    bool makes_attempts() const;
    bool accepts_await_write(timing::Operation const& operation) const;

    timing::ProcessTiming const* process_;
    State state_;
};

}  // namespace dataflow::replay
