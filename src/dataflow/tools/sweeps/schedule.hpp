#pragma once
#include <cstddef>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace dataflow::sweeps {

/// Work for one process.
struct Assignment {
    enum class Kind {
        simulate,  ///< one point
        record,    ///< one point, and an event file with what it does
        retime,    ///< points by their function's event file, as many as there is time for
    };
    Kind kind = Kind::simulate;
    std::string function;
    std::vector<std::size_t> points;
};

/// What came of an assignment.
struct Ending {
    std::vector<std::size_t> done;  ///< points that have a result now; the others are to be done again
    bool has_events = false;        ///< record: the event file is there
    bool lost_events = false;       ///< retime: the event file turned out to be no good
    bool is_lost = false;           ///< the process ended without saying anything
};

/// Decides what is done next, so that every function is simulated once. Points of a function with one point only are
/// simulated; of others the first is recorded, and the rest retimed. If the recorded one deadlocks, there is no event
/// file, and the last is recorded: it is the deepest, as a rule.
class Schedule {
  public:
    struct Job {
        std::size_t point = 0;
        std::string function;
    };
    /// `recorded`: functions whose event files are there.
    Schedule(std::vector<Job> const& jobs, std::set<std::string> const& recorded);

    /// None: there is nothing to do, or it depends on what is being done.
    std::optional<Assignment> next(std::size_t processes);
    void ended(Assignment const& assignment, Ending const& ending);
    /// All points of the function are done.
    bool is_finished(std::string const& function) const;

  private:
    enum class Events { none, in_work, there };
    struct Group {
        std::deque<std::size_t> pending;
        std::size_t in_work = 0;  ///< points
        Events events = Events::none;
        bool first_is_no_good = false;  ///< to be recorded
        bool singly = false;            ///< a process with several points got lost
    };
    using Groups = std::map<std::string, Group>;

    static std::size_t batch_size(Group const& group, std::size_t processes);
    Assignment take(std::string const& function, Assignment::Kind kind, std::size_t count);
    void note(std::string const& function);

    Groups groups_;
    std::vector<std::string> order_;  // of functions: by first point
    std::map<std::string, std::size_t> rank_;
    std::set<std::size_t> retimable_;  // ranks of groups with pending points and an event file
    std::set<std::size_t> startable_;  // with pending points and none
};

}  // namespace dataflow::sweeps
