#pragma once
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "kernel/replay/retime.hpp"
#include "kernel/replay/scripted_run.hpp"
#include "kernel/sizing/cut.hpp"

namespace faster::sizing {

/// How long the cores of a recorded run would take with other FIFOs. Remembers what it has worked out. May be asked by
/// several threads at once.
class CoreTimes {
  public:
    /// A run and its machine, of which all but the FIFOs' depths and kinds counts.
    CoreTimes(replay::RecordedRun const& run, Machine machine);

    /// Those that have samples.
    std::size_t cores() const { return cores_; }

    /// Whether a core takes more than `bound`, if that follows from what is known: more room and less latency never
    /// make a run longer, and room that was never needed makes it no shorter.
    std::optional<bool> known_to_exceed(std::size_t core, Choice const& choice, Cycles bound) const;
    bool exceeds(std::size_t core, Choice const& choice, Cycles bound);
    /// The same, unless it is given up because nobody needs it any more.
    using IsObsolete = std::function<bool()>;
    std::optional<bool> exceeds(std::size_t core, Choice const& choice, Cycles bound, IsObsolete const& is_obsolete);
    /// Whether cycles() has nothing to work out.
    bool is_done(std::size_t core, Choice const& choice) const;
    /// No more than cycles(), of what has been worked out.
    Cycles least_cycles(std::size_t core, Choice const& choice) const;
    /// The capacity of a FIFO that would be enough for all cores, each of which has been worked out.
    std::uint64_t needed_room(Choice const& choice, std::size_t fifo) const;
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
    /// The same of as much as it takes to know that a core takes more than `bound`, so that it proves nothing; of all
    /// if it does not. Nothing if it is given up.
    std::optional<Cut> suspects(std::size_t core, Choice const& choice, Cycles bound,
                                IsObsolete const& is_obsolete = nullptr);
    /// The same of its first `samples`, whatever comes behind them.
    Cut first_suspects(std::size_t core, Choice const& choice, std::size_t samples) const;

    /// Tokens that go through each FIFO, of the core that has most, among those that were seen to end.
    std::vector<std::uint64_t> const& tokens() const { return tokens_; }
    /// How many cores were retimed so far.
    std::size_t retimed_cores() const { return retimed_; }

  private:
    using Place = std::pair<std::size_t, Choice>;
    struct Known {
        Cycles end = 0;
        bool is_left_early = false;       ///< not before `end`, and then nothing is known of room
        std::vector<std::uint64_t> room;  ///< capacities that would have been enough, at most the choice's
    };

    /// Stamps of the process that ends samples, and who writes what it waits for.
    std::vector<Cycles> const& results_of(timing::CoreTiming const& core) const;
    timing::ProcessTiming const* writer_of_results(timing::CoreTiming const& core) const;
    static bool is_as_fast(Choice const& choice, Place const& place, Known const& known);
    std::optional<Known> known(std::size_t core, Choice const& choice) const;
    replay::Leaves as_soon_as_exceeds(std::size_t core, Cycles bound) const;
    std::unique_ptr<timing::CoreTiming> with_trail(std::size_t core, Choice const& choice,
                                                   replay::Leaves const& leaves) const;
    bool enter_as_left(Place const& place, timing::CoreTiming const& core, Cycles bound);
    void work_out(std::vector<std::size_t> const& cores, Choice const& choice);
    /// Retimes a core as far as needed to know whether it takes more than `bound`, unless that is obsolete.
    void work_out_whether_exceeds(std::size_t core, Choice const& choice, Cycles bound,
                                  IsObsolete const& is_obsolete = nullptr);
    std::optional<Cycles> work_of(std::size_t core) const;
    void note_work(std::size_t number, timing::CoreTiming const& core, Cycles end);
    Cycles end_of(timing::CoreTiming& core, std::size_t number) const;
    void enter(Place const& place, timing::CoreTiming& core);

    replay::ScriptedRun const run_;
    Machine const machine_;
    std::size_t cores_;
    std::vector<std::uint64_t> tokens_;  ///< by FIFO
    std::map<Place, Known> known_;       ///< by core first
    /// By core: what the process that writes the results has to do, at least, whatever the FIFOs are.
    std::vector<std::optional<Cycles>> work_;
    std::size_t retimed_ = 0;
    mutable std::mutex mutex_;
};

}  // namespace faster::sizing
