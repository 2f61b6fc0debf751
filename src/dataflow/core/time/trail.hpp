#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "dataflow/base/cycles.hpp"
#include "dataflow/core/time/path_sums.hpp"

namespace dataflow::timing {

constexpr std::size_t most_processes = 64;  ///< of a core
using ProcessMask = std::uint64_t;          ///< a bit each
template <class Number> constexpr ProcessMask bit_of(Number process) { return ProcessMask{1} << process; }

/// One thing that a path through a core's time may turn at. Cycles are relative to whatever holds the event.
struct TrailEvent {
    enum class Kind : std::uint8_t {
        stalled,   ///< `process` waited for `port` until `time`: another process decided when it went on
        marked,    ///< `process` came to another region of its program in `time`
        repeated,  ///< the `distance` stalls before this one happened again `count` times, each time `time` cycles
                   ///< later
        followed,  ///< the next `count` passages, which ended in `time`
        flown,     ///< a token left the flushing pipeline of `process` by `port` in `time`; that was decided `count`
                   ///< cycles before: it was taken in, or (`distance` 1) a place behind `port` became free
    };
    Cycles time = 0;
    std::uint32_t count = 0;  ///< of a stall: steps since its iteration's first
    std::uint32_t distance = 0;
    Kind kind = Kind::stalled;
    std::uint16_t process = 0;
    std::uint16_t port = 0;
    Region region;  ///< of the process, from here on
};

/// Parts of a core's time that are remembered with their trails, to be told by number: see Trail::followed().
class Passages {
  public:
    virtual ~Passages() = default;
    /// What one takes, and what decides it, from its begin on.
    virtual Cycles cycles(std::uint32_t passage) const = 0;
    virtual std::vector<TrailEvent> const& trail(std::uint32_t passage) const = 0;
};

/// What decided the times of one core, in an order in which causes come before effects. Only waiting decides: between
/// two waits a process goes its own way.
class Trail {
  public:
    using Transition = std::uint32_t;  ///< number of a passage
    /// Events, about, from which on it is worth looking for some to forget.
    static constexpr std::size_t usual_length = 1U << 17;
    static constexpr std::size_t any_length = ~std::size_t{0};  ///< never forget

    explicit Trail(std::size_t length = usual_length) : usual_(length), long_(length) {}

    void stalled(unsigned process, unsigned port, Region region, Cycles step, Cycles until);
    void marked(unsigned process, Region region, Cycles from);
    void flown(unsigned process, unsigned port, Cycles flight, bool was_frozen, Cycles cycle);
    /// What the processes of a mask waited for since a mark happened again `count` times, each time
    /// `cycles` later. They did nothing else.
    void repeated(std::uint64_t since, ProcessMask mask, std::uint64_t count, Cycles cycles);
    std::uint64_t mark() const { return forgotten_ + events_.size(); }
    bool remembers(std::uint64_t mark) const { return mark >= forgotten_; }
    /// A passage that ended in `end`; the one before it ended where this began.
    void followed(Transition transition, Cycles end, bool goes_on);
    /// What the numbers of passages mean.
    void set_passages(Passages const* passages) { passages_ = passages; }
    Passages const* passages() const { return passages_; }
    void append(TrailEvent event, Cycles later);
    /// All that was taken down since the last call, in cycles since `origin`, which may be in the future.
    std::vector<TrailEvent> take(Cycles origin);

    std::vector<TrailEvent> const& events() const { return events_; }
    std::vector<Transition> const& transitions() const { return transitions_; }

    /// Where all paths come together: what is before it has been summed up and forgotten.
    struct Junction {
        unsigned process = 0;
        Cycles time = 0;
        PathSums sums;
    };
    std::optional<Junction> const& junction() const { return junction_; }
    /// Forgets the first events, and transitions, in favour of a junction.
    void forget(std::size_t events, std::size_t transitions, Junction junction);
    /// True from time to time: when there is more to forget than was left the last time.
    bool is_long() const { return length() > long_; }
    void accept_length() { long_ = usual_ + 2 * length(); }

  private:
    std::size_t length() const { return events_.size() + transitions_.size() / 8; }

    std::vector<TrailEvent> events_;
    std::vector<Transition> transitions_;
    std::optional<Junction> junction_;
    std::size_t usual_;
    std::size_t long_;
    std::uint64_t forgotten_ = 0;
    Passages const* passages_ = nullptr;
};

}  // namespace dataflow::timing
