#include "tool/sweeper.hpp"

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <utility>

#include "kernel/base/input_error.hpp"
#include "kernel/base/on_threads.hpp"
#include "tool/budget_run.hpp"

namespace faster {

Sweeper::Sweeper(SweepRequest const& request, sweeps::Sweep const& sweep,
                 std::vector<sweeps::PointIdentity> const& identities, std::vector<std::size_t> const& points,
                 sweeps::SweepFolder const& folder, sweeps::Journal& journal)
    : request_(request),
      sweep_(sweep),
      identities_(identities),
      folder_(folder),
      journal_(journal),
      all_(points.size()),
      pending_(pending_of(points)),
      schedule_(pending_, recorded_functions()),
      done_(all_ - pending_.size()),
      progress_("points", done_) {}

void Sweeper::work(processes::SignalWatch const& watch) {
    processes::TaskStream stream;
    stream.next = [this](std::size_t number) { return next(number); };
    stream.ended = [this](std::size_t number, processes::Outcome const& outcome) { ended(number, outcome); };
    processes::run_stream(stream, processes(), watch);
    if (!request_.keep_events)
        remove_all_events();
}

std::size_t Sweeper::processes() const { return jobs_or_host_cores(request_.jobs); }

std::vector<sweeps::Schedule::Job> Sweeper::pending_of(std::vector<std::size_t> const& points) const {
    std::vector<sweeps::Schedule::Job> pending;
    for (std::size_t const point : points)
        if (journal_.results().count(identities_[point].point) == 0)
            pending.push_back({point, identities_[point].function});
    return pending;
}

/// Whether a file is whole is found out by the process that reads it.
std::set<std::string> Sweeper::recorded_functions() const {
    std::set<std::string> functions;
    for (sweeps::Schedule::Job const& job : pending_)
        if (std::filesystem::exists(folder_.events(job.function)))
            functions.insert(job.function);
    return functions;
}

std::optional<processes::Task> Sweeper::next(std::size_t number) {
    auto const assignment = schedule_.next(processes());
    if (!assignment)
        return std::nullopt;
    at_work_[number] = *assignment;
    std::filesystem::path const events = folder_.events(assignment->function);
    return processes::Task{
        [this, given = *assignment, events] { return to_text(work_on(given, sweep_, identities_, events)); },
        request_.time_limit_s};
}

void Sweeper::ended(std::size_t number, processes::Outcome const& outcome) {
    sweeps::Assignment const assignment = at_work_.at(number);
    at_work_.erase(number);
    SweepReply const reply = reply_of(assignment, outcome);
    write_down(reply);
    if (!reply.trouble.empty())
        throw InputError(reply.trouble);
    sweeps::Ending ending{{}, reply.has_events, reply.lost_events, outcome.kind != processes::Outcome::Kind::done};
    for (auto const& [point, result] : reply.results)
        ending.done.push_back(point);
    schedule_.ended(assignment, ending);
    remove_useless_events(assignment, reply);
    done_ += reply.results.size();
    progress_.show(done_, all_);
}

/// A process that got lost with several points says nothing about any of them: they are done again, one by one. One
/// that was killed (by the system, for want of memory, or by somebody) says nothing about its point for ever.
SweepReply Sweeper::reply_of(sweeps::Assignment const& assignment, processes::Outcome const& outcome) const {
    if (outcome.kind == processes::Outcome::Kind::done)
        return reply_from_text(outcome.output);
    SweepReply reply;
    if (assignment.points.size() == 1)
        reply.results.emplace_back(assignment.points.front(),
                                   sweeps::failed(why_no_result(outcome, request_.time_limit_s)));
    using End = processes::Outcome::Kind;
    reply.was_killed = outcome.kind == End::failed || (outcome.kind == End::crashed && outcome.signal == SIGKILL);
    return reply;
}

void Sweeper::write_down(SweepReply const& reply) {
    std::vector<std::pair<std::string, sweeps::PointResult>> rows;
    for (auto const& [point, result] : reply.results)
        rows.emplace_back(identities_[point].point, result);
    if (reply.was_killed)
        journal_.note(rows);
    else if (!rows.empty())
        journal_.append(rows);
}

void Sweeper::remove_useless_events(sweeps::Assignment const& assignment, SweepReply const& reply) const {
    bool const is_done = schedule_.is_finished(assignment.function) && !request_.keep_events;
    if (is_done || reply.lost_events)
        std::filesystem::remove(folder_.events(assignment.function));
}

/// Also those of functions that a process had done that was ended before it could remove them.
void Sweeper::remove_all_events() const {
    for (sweeps::PointIdentity const& identity : identities_)
        std::filesystem::remove(folder_.events(identity.function));
    folder_.remove_events_folder();
}

}  // namespace faster
