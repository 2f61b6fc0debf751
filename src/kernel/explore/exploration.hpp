#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "kernel/base/json.hpp"
#include "kernel/config/load_config.hpp"
#include "kernel/explore/job.hpp"
#include "kernel/replay/recorded_run.hpp"
#include "kernel/replay/scripted_run.hpp"

namespace faster::explore {

/// "a.b.c=value" each, to be put over what was recorded.
using Overrides = std::vector<std::string>;

/// A recorded run that somebody tries other timing on. Answers are JSON; the page that asks for them only draws. May be
/// asked by several threads at once. Throws InputError for overrides that a retiming does not take, as `whatif` does.
class Exploration {
  public:
    /// `title`: what the page is called.
    Exploration(std::string title, LoadedConfig recorded, replay::RecordedRun run);

    std::string const& title() const { return title_; }
    /// Everything about the run that no override changes: the graph, the keys that may be changed and what they mean.
    Json design() const;
    /// The figures of the run with overrides: cycles, what FIFOs take, modules, FIFOs, loops. A deadlock is one of
    /// them. `yaml` is a configuration that does the same.
    Json retimed(Overrides const& overrides) const;
    /// Along which operations its cycles come about. Null of a deadlock, and where cores share a memory.
    Json critical_path(Overrides const& overrides) const;
    /// Work to be done in the background.
    Job::Work sensitivities(Overrides const& overrides) const;
    Job::Work sizing(Overrides const& overrides, double within_percent) const;

  private:
    RunConfig changed(Overrides const& overrides) const;

    std::string title_;
    LoadedConfig recorded_;
    replay::RecordedRun run_;
    replay::ScriptedRun scripted_;  ///< of the run
};

}  // namespace faster::explore
