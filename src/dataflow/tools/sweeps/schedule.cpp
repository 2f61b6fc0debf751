#include "dataflow/tools/sweeps/schedule.hpp"

#include <algorithm>

namespace dataflow::sweeps {

Schedule::Schedule(std::vector<Job> const& jobs, std::set<std::string> const& recorded) {
    for (Job const& job : jobs) {
        if (rank_.try_emplace(job.function, order_.size()).second)
            order_.push_back(job.function);
        groups_[job.function].pending.push_back(job.point);
    }
    for (auto& [function, group] : groups_) {
        group.events = recorded.count(function) > 0 ? Events::there : Events::none;
        note(function);
    }
}

std::optional<Assignment> Schedule::next(std::size_t processes) {
    if (!retimable_.empty()) {
        std::string const& function = order_[*retimable_.begin()];
        return take(function, Assignment::Kind::retime, batch_size(groups_.at(function), processes));
    }
    if (startable_.empty())
        return std::nullopt;
    std::string const& function = order_[*startable_.begin()];
    std::deque<std::size_t>& pending = groups_.at(function).pending;
    if (groups_.at(function).first_is_no_good)
        std::rotate(pending.begin(), pending.end() - 1, pending.end());
    return take(function, pending.size() == 1 ? Assignment::Kind::simulate : Assignment::Kind::record, 1);
}

/// Several, as a process may cost more than a point; not too many, so that all processes are busy to the end.
std::size_t Schedule::batch_size(Group const& group, std::size_t processes) {
    constexpr std::size_t most = 64;
    return group.singly
               ? 1
               : std::clamp<std::size_t>(group.pending.size() / (2 * std::max<std::size_t>(processes, 1)), 1, most);
}

Assignment Schedule::take(std::string const& function, Assignment::Kind kind, std::size_t count) {
    Group& group = groups_.at(function);
    auto const end = group.pending.begin() + static_cast<std::ptrdiff_t>(count);
    Assignment assignment{kind, function, {group.pending.begin(), end}};
    group.pending.erase(group.pending.begin(), end);
    group.in_work += count;
    if (kind == Assignment::Kind::record)
        group.events = Events::in_work;
    note(function);
    return assignment;
}

void Schedule::ended(Assignment const& assignment, Ending const& ending) {
    Group& group = groups_.at(assignment.function);
    group.in_work -= assignment.points.size();
    for (auto point = assignment.points.rbegin(); point != assignment.points.rend(); ++point)
        if (std::find(ending.done.begin(), ending.done.end(), *point) == ending.done.end())
            group.pending.push_front(*point);
    group.singly = group.singly || ending.is_lost;
    if (assignment.kind == Assignment::Kind::record) {
        group.events = ending.has_events ? Events::there : Events::none;
        group.first_is_no_good = !ending.has_events;
    }
    if (ending.lost_events)
        group.events = Events::none;
    note(assignment.function);
}

bool Schedule::is_finished(std::string const& function) const {
    Group const& group = groups_.at(function);
    return group.pending.empty() && group.in_work == 0;
}

void Schedule::note(std::string const& function) {
    Group const& group = groups_.at(function);
    std::size_t const rank = rank_.at(function);
    retimable_.erase(rank);
    startable_.erase(rank);
    if (!group.pending.empty() && group.events == Events::there)
        retimable_.insert(rank);
    if (!group.pending.empty() && group.events == Events::none)
        startable_.insert(rank);
}

}  // namespace dataflow::sweeps
