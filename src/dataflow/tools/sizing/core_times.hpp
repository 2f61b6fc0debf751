#pragma once
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "dataflow/run/replay/retime.hpp"
#include "dataflow/run/replay/scripted_run.hpp"
#include "dataflow/tools/sizing/cut.hpp"
#include "dataflow/tools/sizing/relaxation.hpp"

namespace dataflow::sizing {

/// How long the cores of a recorded run would take with other FIFOs. Remembers what it has worked out. May be asked by
/// several threads at once. Where times are not monotone it knows those of the relaxed machine besides. Cores that
/// share a memory are all retimed when one is.
class CoreTimes {
  public:
    /// Called before each retiming of a core, from any thread; may throw, to give up.
    using BeforeRetiming = std::function<void()>;

    /// A run and its machine, of which all but the FIFOs' depths and kinds counts.
    CoreTimes(replay::RecordedRun const& run, Machine const& machine, BeforeRetiming before_retiming = nullptr);

    /// More room and less latency never make a run longer.
    bool is_monotone() const { return relaxed_ == nullptr; }
    /// Whether no core can be retimed without the others.
    bool are_together() const { return are_together_; }
    /// Times that are: these, or else those of the relaxed machine.
    CoreTimes& relaxed() { return is_monotone() ? *this : *relaxed_; }

    /// Those that have samples.
    std::size_t cores() const { return cores_; }

    /// Whether a core takes more than `bound`, if that follows from what is known. Where times are monotone, more room
    /// and less latency make no run longer, and room that was never needed makes none shorter. Where not, a run is the
    /// same as another if they differ in nothing but room that neither needs, and no shorter than on the relaxed
    /// machine.
    std::optional<bool> known_to_exceed(std::size_t core, Choice const& choice, Cycles bound) const;
    bool exceeds(std::size_t core, Choice const& choice, Cycles bound);
    /// Whether a core exceeds `bound`; nothing if it is given up because nobody needs it any more.
    using IsObsolete = std::function<bool()>;
    std::optional<bool> exceeds(std::size_t core, Choice const& choice, Cycles bound, IsObsolete const& is_obsolete);
    /// Whether cycles() has nothing to work out.
    bool is_done(std::size_t core, Choice const& choice) const;
    /// No more than cycles(), of what has been worked out.
    Cycles least_cycles(std::size_t core, Choice const& choice) const;
    /// The capacity that a FIFO would need never to be full, in any core, each of which has been worked out. No more
    /// than it has if it has been full.
    std::uint64_t needed_room(Choice const& choice, std::size_t fifo) const;
    /// Whether it has been full in one of them.
    bool was_full(Choice const& choice, std::size_t fifo) const;
    /// The first core that does; cores() if none does. On up to `jobs` threads.
    std::size_t first_to_exceed(Choice const& choice, Cycles bound, unsigned jobs);
    /// One past a core's last result read, or Cut::deadlock.
    Cycles cycles(std::size_t core, Choice const& choice);
    /// The cycles of the core that takes longest, all at once on up to `jobs` threads: total_cycles, or Cut::deadlock.
    Cycles total_cycles(Choice const& choice, unsigned jobs);
    /// Why a core takes as long as it does, or never ends: the FIFOs where its critical path turns, or those that are
    /// full in the deadlock.
    Cut explain(std::size_t core, Choice const& choice);
    /// explain() of as much as it takes to know that a core takes more than `bound`, so that it proves nothing; of all
    /// if it does not. Nothing if it is given up.
    std::optional<Cut> suspects(std::size_t core, Choice const& choice, Cycles bound,
                                IsObsolete const& is_obsolete = nullptr);
    /// explain() of a core's first `samples`, whatever comes behind them.
    Cut first_suspects(std::size_t core, Choice const& choice, std::size_t samples) const;

    /// Tokens that go through each FIFO, of the core that has most, among those that were seen to end.
    std::vector<std::uint64_t> const& tokens() const { return is_monotone() ? tokens_ : relaxed_->tokens(); }
    /// How many cores were retimed so far, on the relaxed machine as well.
    std::size_t retimed_cores() const { return retimed_ + (is_monotone() ? 0 : relaxed_->retimed_cores()); }

  private:
    using CoreChoice = std::pair<std::size_t, Choice>;
    struct Known {
        Cycles end = 0;
        bool is_left_early = false;  ///< not before `end`, and then nothing is known of room
        /// Capacities with which FIFOs are never full, here or in a core that was retimed with it; more than they have:
        /// it was.
        std::vector<std::uint64_t> room;
    };
    using Run = std::shared_ptr<replay::ScriptedRun const>;

    CoreTimes(Run run, Machine machine, Cycles load, std::vector<std::uint64_t> writes, BeforeRetiming before_retiming);

    /// Stamps of the process that ends samples, and who writes what it waits for.
    std::vector<Cycles> const& results_of(timing::CoreTiming const& core) const;
    timing::ProcessTiming const* writer_of_results(timing::CoreTiming const& core) const;
    static bool is_as_fast(Choice const& choice, CoreChoice const& place, Known const& known);
    static bool is_same(Choice const& choice, CoreChoice const& place, Known const& known);
    bool is_told_by(CoreChoice const& place, Known const& known, Choice const& choice, bool exceeds) const;
    bool has_frozen(Choice const& choice, Known const& known) const;
    std::optional<Known> known(std::size_t core, Choice const& choice) const;
    replay::Leaves as_soon_as_exceeds(std::size_t core, Cycles bound) const;
    /// Those that have to be retimed with it.
    std::vector<std::size_t> with(std::size_t core) const;
    replay::Cores with_trails(std::size_t core, Choice const& choice, replay::Leaves const& leaves) const;
    bool enter_as_left(CoreChoice const& place, timing::CoreTiming const& core, Cycles bound);
    /// As retime_cores() does.
    replay::Cores retimed(std::vector<std::size_t> const& cores, Choice const& choice,
                          replay::CoreOptions const& options) const;
    void work_out(std::vector<std::size_t> const& cores, Choice const& choice);
    /// Retimes a core as far as needed to know whether it takes more than `bound`, unless that is obsolete.
    void work_out_whether_exceeds(std::size_t core, Choice const& choice, Cycles bound,
                                  IsObsolete const& is_obsolete = nullptr);
    std::optional<Cycles> work_of(std::size_t core) const;
    void note_work(std::size_t number, timing::CoreTiming const& core, Cycles end);
    Cycles end_of(timing::CoreTiming& core, std::size_t number) const;
    void enter(std::vector<std::size_t> const& cores, Choice const& choice, replay::Cores const& timings);
    Known outcome(std::size_t number, timing::CoreTiming& core);

    Run const run_;
    Machine const machine_;
    Cycles const load_;                        ///< before the cores begin
    std::vector<std::uint64_t> const writes_;  ///< writes_in_a_cycle()
    BeforeRetiming const before_retiming_;
    std::vector<std::size_t> const freezing_;
    bool const are_together_;
    std::unique_ptr<CoreTimes> const relaxed_;  ///< null: these times are monotone
    std::size_t cores_;
    std::vector<std::uint64_t> tokens_;  ///< by FIFO
    std::map<CoreChoice, Known> known_;  ///< by core first
    /// By core: what the process that writes the results has to do, at least, whatever the FIFOs are.
    std::vector<std::optional<Cycles>> work_;
    std::size_t retimed_ = 0;
    mutable std::mutex mutex_;
};

}  // namespace dataflow::sizing
