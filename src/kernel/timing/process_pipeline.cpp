#include "kernel/timing/process_timing.hpp"

// Loops whose tokens leave in different stages: what an iteration writes later waits in a delay line.

namespace faster::timing {

void ProcessTiming::open_iteration(std::uint8_t ports) {
    bool const drains = log_.front().kind() == Operation::Kind::leave;
    if (observer_ != nullptr && !drains)
        observer_->iterated(*this, time_, pipeline_.iteration, 1, plan().ii);
    plan().delay_line[pipeline_.iteration % plan().delay_line.size()] = ports;
    pipeline_.open = true;
    pipeline_.phase = 0;
    pipeline_.offset = 0;
}

/// Moves through the II steps of one iteration of an unaligned loop; true: at a step with accesses, false: at its end.
bool ProcessTiming::find_step_in_pipeline(std::uint8_t ports) {
    LoopPlan& loop = plan();
    if (!pipeline_.open)
        open_iteration(ports);
    for (; pipeline_.phase < loop.phases.size(); ++pipeline_.phase) {
        Phase const& phase = loop.phases[pipeline_.phase];
        time_ += phase.offset - pipeline_.offset;
        pipeline_.offset = phase.offset;
        for (auto const& [port, lag] : phase.ports)
            if (pipeline_.iteration >= lag)
                front_ports_ |= static_cast<std::uint8_t>(
                    loop.delay_line[(pipeline_.iteration - lag) % loop.delay_line.size()] & (1U << port));
        if (front_ports_ != 0)
            return true;
    }
    time_ += loop.ii - pipeline_.offset;
    pipeline_.open = false;
    ++pipeline_.iteration;
    return false;
}

/// Lets an unaligned loop's last tokens leave; then moves to the end of the loop's last stage.
bool ProcessTiming::find_step_while_draining() {
    LoopPlan& loop = plan();
    if (pipeline_.drain_left == loop.longest_lag && !pipeline_.open)
        mark(Region::of_loop(current_loop_, Region::Part::drain), time_);
    for (; pipeline_.drain_left > 0; --pipeline_.drain_left)
        if (find_step_in_pipeline(0))
            return true;
    // The steps that draining walked through belong to the loop's depth, of which `drain` is the rest.
    move(loop.drain - static_cast<std::int64_t>(loop.longest_lag * loop.ii));
    return false;
}

}  // namespace faster::timing
