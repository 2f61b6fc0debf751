#pragma once
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "kernel/sweeps/point_identity.hpp"
#include "kernel/sweeps/point_result.hpp"
#include "kernel/sweeps/schedule.hpp"
#include "kernel/sweeps/sweep.hpp"

namespace faster {

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

}  // namespace faster
