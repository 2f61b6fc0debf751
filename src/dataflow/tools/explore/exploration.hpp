#pragma once
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "dataflow/base/json.hpp"
#include "dataflow/core/machine/machine.hpp"
#include "dataflow/run/config/load_config.hpp"
#include "dataflow/run/events/event_file.hpp"
#include "dataflow/run/figures/run_statistics.hpp"
#include "dataflow/run/figures/sample_timeline.hpp"
#include "dataflow/run/replay/recorded_run.hpp"
#include "dataflow/run/replay/scripted_run.hpp"
#include "dataflow/tools/explore/job.hpp"

namespace dataflow::explore {

/// "a.b.c=value" each, to be put over what was recorded.
using Overrides = std::vector<std::string>;

/// A recorded run that somebody tries other timing on. Answers are JSON; the page that asks for them only draws. May be
/// asked by several threads at once. Throws InputError for overrides that a retiming does not take, as `whatif` does.
class Exploration {
  public:
    /// `title`: what the page is called.
    /// Throws InputError for a machine that the host has no room for.
    using Require = std::function<void(replay::RecordedRun const& run, Machine const& machine)>;
    /// Simulates and records a configuration, a text in YAML. Throws InputError if that does not come to its end.
    using RunAgain = std::function<events::EventFile(std::string const& yaml)>;

    /// `require`: asked before anything is retimed; may be empty. `run_again`: for overrides with which a non-blocking
    /// access would find something else than was recorded; if it is empty, those are refused.
    Exploration(std::string title, LoadedConfig recorded, replay::RecordedRun run, Require require = {},
                RunAgain run_again = {});

    std::string const& title() const { return title_; }
    /// Everything about the run that no override changes: the graph, the keys that may be changed and what they mean.
    Json design() const;
    /// The figures of the run with overrides: cycles, what FIFOs take, modules, FIFOs, loops. A deadlock is one of
    /// them. `yaml` is a configuration that does the same.
    Json retimed(Overrides const& overrides);
    /// Along which operations its cycles come about. Null of a deadlock.
    Json critical_path(Overrides const& overrides);
    /// What the modules did from one cycle to another of a sample; `to` 0: to its end. Throws InputError if there is no
    /// such sample.
    Json timeline(Overrides const& overrides, std::size_t sample, Cycles from, Cycles to);
    /// Work to be done in the background.
    Job::Work sensitivities(Overrides const& overrides);
    Job::Work sizing(Overrides const& overrides, double within_percent);

  private:
    std::shared_ptr<Exploration> other_run(Overrides const& overrides);
    RunConfig changed(Overrides const& overrides) const;
    std::shared_ptr<RunStatistics const> retimed_run(Overrides const& overrides);

    std::string title_;
    LoadedConfig recorded_;
    replay::RecordedRun run_;
    Require require_;
    RunAgain run_again_;            ///< empty of a design without such accesses
    replay::ScriptedRun scripted_;  ///< of the run

    struct TimelineOf {
        Machine machine;
        SampleTimeline timeline;
    };
    std::shared_ptr<TimelineOf const> timeline_of(Overrides const& overrides, std::size_t sample);

    /// What was made last. It is likely to be asked for again: by who has seen a run's figures, for a sample of it; by
    /// who zooms, for a part of a timeline.
    template <class Made> class Last {
      public:
        /// Null: it was made for something else.
        std::shared_ptr<Made> find(Overrides const& overrides, std::size_t sample = 0) {
            std::lock_guard<std::mutex> const lock(mutex_);
            return overrides == overrides_ && sample == sample_ ? made_ : nullptr;
        }
        std::shared_ptr<Made> keep(std::shared_ptr<Made> made, Overrides const& overrides, std::size_t sample = 0) {
            std::lock_guard<std::mutex> const lock(mutex_);
            overrides_ = overrides;
            sample_ = sample;
            return made_ = std::move(made);
        }

      private:
        std::mutex mutex_;
        Overrides overrides_;
        std::size_t sample_ = 0;
        std::shared_ptr<Made> made_;
    };
    Last<Exploration> last_other_;
    Last<RunStatistics const> last_run_;
    Last<TimelineOf const> last_timeline_;
};

}  // namespace dataflow::explore
