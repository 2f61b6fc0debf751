#pragma once
#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "dataflow/base/process_pool.hpp"
#include "dataflow/commands/progress_line.hpp"
#include "dataflow/commands/sweep_command.hpp"
#include "dataflow/tools/sweeps/journal.hpp"
#include "dataflow/tools/sweeps/point_identity.hpp"
#include "dataflow/tools/sweeps/point_result.hpp"
#include "dataflow/tools/sweeps/schedule.hpp"
#include "dataflow/tools/sweeps/sweep.hpp"
#include "dataflow/tools/sweeps/sweep_folder.hpp"

namespace dataflow {

/// What a process that works on a sweep has to say.
struct SweepReply {
    std::vector<std::pair<std::size_t, sweeps::PointResult>> results;  ///< by point
    bool has_events = false;                                           ///< the event file is there
    bool lost_events = false;                                          ///< the event file is no good
    bool was_killed = false;                                           ///< a repeat of the sweep tries again
    std::string trouble;  ///< why the sweep cannot go on now, say a full disk; empty: all is well
};

/// Does an assignment, in a process of its own: it may simulate. Whatever is wrong with a point is its result; trouble
/// if it is not the point of that identity any more, since a file changed while the sweep was at work.
SweepReply work_on(sweeps::Assignment const& assignment, sweeps::Sweep const& sweep,
                   std::vector<sweeps::PointIdentity> const& identities, std::filesystem::path const& events);

/// A reply for another process, and back.
std::string to_text(SweepReply const& reply);
SweepReply reply_from_text(std::string const& text);

/// Lets processes do the points of a sweep that have no result yet, and writes results down as they come. What it is
/// made with has to outlive it.
class Sweeper {
  public:
    /// `points`: those to be done, by number.
    Sweeper(SweepRequest const& request, sweeps::Sweep const& sweep,
            std::vector<sweeps::PointIdentity> const& identities, std::vector<std::size_t> const& points,
            sweeps::SweepFolder const& folder, sweeps::Journal<sweeps::PointResult>& journal);

    /// How many have no result yet.
    std::size_t pending() const { return pending_.size(); }
    /// Until all have one. Throws InputError if nothing can be written.
    void work(processes::SignalWatch const& watch);

  private:
    std::size_t processes() const;
    std::vector<sweeps::Schedule::Job> pending_of(std::vector<std::size_t> const& points) const;
    std::set<std::string> recorded_functions() const;
    std::optional<processes::Task> next(std::size_t number);
    void ended(std::size_t number, processes::Outcome const& outcome);
    SweepReply reply_of(sweeps::Assignment const& assignment, processes::Outcome const& outcome) const;
    void write_down(SweepReply const& reply);
    void remove_useless_events(sweeps::Assignment const& assignment, SweepReply const& reply) const;
    void remove_all_events() const;

    SweepRequest const& request_;
    sweeps::Sweep const& sweep_;
    std::vector<sweeps::PointIdentity> const& identities_;
    sweeps::SweepFolder const& folder_;
    sweeps::Journal<sweeps::PointResult>& journal_;
    std::size_t all_;
    std::vector<sweeps::Schedule::Job> pending_;
    sweeps::Schedule schedule_;
    std::size_t done_;
    ProgressLine progress_;
    std::map<std::size_t, sweeps::Assignment> at_work_;  // by number of the task
};

}  // namespace dataflow
