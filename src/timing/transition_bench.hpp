#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "timing/phrase.hpp"
#include "timing/relative_state.hpp"
#include "timing/transition.hpp"

namespace faster::timing {

class CoreTiming;

/// Works out transitions, operation by operation, on a core of its own.
class TransitionBench {
  public:
    using Words = RelativeState::Words;

    /// For cores of that shape, which leave trails or do not.
    TransitionBench(CoreTiming const& core, Lead const& lead, bool leaves_trails);
    ~TransitionBench();

    /// Charges the followers that wait for the driver (RelativeState::park), from a state on. By follower.
    std::vector<RelativeState::Waiting> park(Words const& from);
    /// What park() made counters grow by, and left on the trail.
    std::vector<Transition::Growth> const& parking_growth() const { return parking_growth_; }
    std::vector<TrailEvent> take_trail();

    /// Performs a phrase. False if the driver cannot finish it.
    bool work_out(Words const& from, Phrase const& phrase, Transition& transition);

    /// The state that the last call led to, and the largest distance in time in it.
    Words const& words() const { return words_; }
    std::int64_t reach() const { return state_.reach(); }
    /// Of the driver, where the last call began.
    Cycles time() const { return time_; }

  private:
    /// Each call begins long after all times of the one before.
    static constexpr Cycles first_time = Cycles{1} << 40;
    static constexpr Cycles time_apart = Cycles{1} << 40;
    static constexpr Cycles last_time = Cycles{1} << 62;

    void start_from(Words const& from);
    void forget_growth();
    std::uint32_t processes_of(Phrase const& phrase) const;
    void describe(Phrase const& phrase, Transition& transition);
    void describe_stands(Phrase const& phrase, Transition& transition);
    void describe_rooms(Transition& transition);
    void take_growth(std::vector<Transition::Growth>& growth);
    void describe_peaks(std::vector<Transition::Peak>& peaks) const;

    std::unique_ptr<CoreTiming> core_;
    Group group_;
    RelativeState state_;
    std::vector<std::uint64_t*> counters_;
    std::vector<Transition::Growth> growth_;  ///< to write on: one entry more than there can be
    Cycles time_ = first_time;
    bool leaves_trails_;
    std::vector<Transition::Growth> parking_growth_;
    Words words_;
    // Where the members stood before a transition.
    template <class Value> using ByMember = std::array<Value, Transition::most_members>;
    ByMember<Cycles> times_before_{};
    ByMember<std::uint64_t> entries_before_{};  ///< of loops
    ByMember<unsigned> ports_before_{};         ///< waited for
};

}  // namespace faster::timing
