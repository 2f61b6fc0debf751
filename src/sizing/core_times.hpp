#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "retiming/scripted_run.hpp"
#include "sizing/cut.hpp"

namespace faster::sizing {

/// How long the cores of a recorded run would take with other FIFOs. Remembers what it has worked out. May be asked by
/// several threads at once.
class CoreTimes {
  public:
    /// A run and its configuration, of which all but the FIFOs' depths and kinds counts.
    CoreTimes(retiming::RecordedRun const& run, AcceleratorConfig config);

    /// Those that have samples.
    std::size_t cores() const { return cores_; }

    /// Whether a core takes more than `bound`, if that follows from what is known: more room and less latency never
    /// make a run longer.
    std::optional<bool> known_to_exceed(std::size_t core, Choice const& choice, Cycles bound) const;
    bool exceeds(std::size_t core, Choice const& choice, Cycles bound);
    /// The first core that does; cores() if none does. On up to `jobs` threads.
    std::size_t first_to_exceed(Choice const& choice, Cycles bound, unsigned jobs);
    /// One past a core's last result read, or Cut::deadlock.
    Cycles cycles(std::size_t core, Choice const& choice);
    /// The same for several cores at once, on up to `jobs` threads: the largest. That is total_cycles, or
    /// Cut::deadlock.
    Cycles total_cycles(Choice const& choice, unsigned jobs);
    /// Why a core takes as long as it does, or never ends: the FIFOs where its critical path turns, or those that are
    /// full in the deadlock.
    Cut explain(std::size_t core, Choice const& choice);

    /// Tokens that go through each FIFO, of the core that has most, among those that were seen to end.
    std::array<std::uint64_t, fifo_count> const& tokens() const { return tokens_; }
    /// How many cores were retimed so far.
    std::size_t retimed_cores() const { return retimed_; }

  private:
    using Place = std::pair<std::size_t, Choice>;

    /// Whether cycles() has nothing to work out.
    bool is_known(std::size_t core, Choice const& choice) const;
    void work_out(std::vector<std::size_t> const& cores, Choice const& choice);
    Cycles end_of(timing::CoreTiming& core, std::size_t number) const;
    void enter(Place const& place, timing::CoreTiming& core);

    retiming::ScriptedRun const run_;
    AcceleratorConfig const config_;
    std::size_t cores_;
    std::array<std::uint64_t, fifo_count> tokens_{};
    std::map<Place, Cycles> known_;  ///< by core first
    std::size_t retimed_ = 0;
    mutable std::mutex mutex_;
};

}  // namespace faster::sizing
