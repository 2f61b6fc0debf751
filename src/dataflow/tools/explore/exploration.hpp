#pragma once
#include <functional>
#include <memory>
#include <mutex>
#include <string>
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

    struct KeptRun {
        Overrides overrides;
        std::shared_ptr<RunStatistics const> run;
    };
    struct KeptTimeline {
        Overrides overrides;
        Machine machine;
        SampleTimeline timeline;
    };
    std::shared_ptr<KeptTimeline const> kept_timeline(Overrides const& overrides, std::size_t sample);
    std::mutex mutex_;
    struct OtherRun {
        Overrides overrides;
        std::shared_ptr<Exploration> exploration;
    };
    OtherRun other_run_;  ///< the last that was recorded
    KeptRun kept_run_;    ///< the last one: who has seen its figures asks for a sample of it
    std::shared_ptr<KeptTimeline const> kept_;
};

}  // namespace dataflow::explore
