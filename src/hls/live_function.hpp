#pragma once
#include <array>
#include <cstdint>
#include <set>
#include <utility>

#include "channels/process_clock.hpp"
#include "hls/hls_design.hpp"
#include "hls/observer.hpp"

namespace dataflow {

/// One function of a design while it runs beside the clock of its process: what it finds where it does not wait, it
/// finds in that cycle. What it does in the loops of its description are their iterations, anything else takes a cycle.
///
/// An iteration is told of when the function does something else, so that its end, which may come by an exception, says
/// nothing. What the condition of a loop asks of a stream belongs to the iteration that it lets begin, or if it lets
/// none begin, to one that does nothing else, as in hardware. Who asks the same again looks in the next iteration.
class LiveFunction final : public untimed::Observer {
  public:
    LiveFunction(HlsCore& core, ProcessClock& clock, std::size_t process)
        : core_(core), clock_(clock), process_(process) {}

    void run();

  private:
    std::size_t process() const override { return process_; }
    void reads(untimed::StreamBase& stream) override;
    void wrote(untimed::StreamBase& stream) override;
    bool attempts(untimed::StreamBase const& stream, untimed::Attempt const& attempt) override;
    void asks_size(untimed::StreamBase const& stream) override { untimed::refuse_size(stream); }
    void meets_stranger(untimed::StreamBase const& stream) override { untimed::refuse_stranger(stream); }
    void begins_iteration(untimed::LoopMark const& loop) override;
    void ends_iteration(untimed::LoopMark const& loop) noexcept override;

    enum class Where {
        outside,    ///< loops
        iteration,  ///< in one
        condition,  ///< in one that has not begun yet, or never will
        between     ///< behind one
    };
    bool is_around(untimed::LoopMark const& loop) const;
    void open_iteration();
    void come_to_question(untimed::Access const& access);
    void come_to_access();
    void begin_access(untimed::Access const& access, bool is_attempt);
    void leave_loop();
    void go_on();
    void end_access();
    bool find(ClockedFifo<std::int64_t>& fifo, untimed::Attempt const& attempt) const;

    HlsCore& core_;
    ProcessClock& clock_;
    std::size_t process_;
    Where where_ = Where::outside;
    untimed::LoopMark const* loop_ = nullptr;  ///< that it is in
    std::uint64_t iterations_ = 0;             ///< of it, begun
    bool is_open_ = false;                     ///< the last of them has not been told
    bool leaves_ = false;                      ///< a loop around it has gone on
    untimed::Accesses asked_;                  ///< of the last of them
    untimed::IdleIterations idle_;
    /// That it makes, in loops or in none: that wait, and that do not.
    std::array<std::set<std::pair<untimed::LoopMark const*, untimed::Access>>, 2> described_;
};

}  // namespace dataflow
