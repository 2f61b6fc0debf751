#pragma once
#include <algorithm>
#include <vector>

namespace dataflow::timing {

/// Who sets the pace of a core: a driver, and processes that only answer to what it does. The anchor of a follower is
/// the FIFO between it and the driver by whose accesses its work is counted: for every access the driver makes, the
/// follower has one to make. A statement about efficiency only: cycles never depend on it.
struct Lead {
    static constexpr unsigned most_members = 5;  ///< the driver and its followers

    struct Follower {
        unsigned process = 0;
        unsigned anchor = 0;  ///< number of a FIFO
    };
    unsigned driver = 0;  ///< number of a process
    std::vector<Follower> followers;

    /// The driver or a follower, if there are any.
    bool has(unsigned process) const {
        auto const is_it = [process](Follower const& follower) { return follower.process == process; };
        bool const follows = std::any_of(followers.begin(), followers.end(), is_it);
        return follows || (process == driver && !followers.empty());
    }
};

}  // namespace dataflow::timing
