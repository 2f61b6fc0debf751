#include "dataflow/commands/sweeper.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fmt/format.h>

#include "dataflow/base/files/json_file.hpp"
#include "dataflow/base/files/output_file.hpp"
#include "dataflow/base/host_clock.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/base/json.hpp"
#include "dataflow/base/on_threads.hpp"
#include "dataflow/commands/budget_run.hpp"
#include "dataflow/commands/recorded_events.hpp"
#include "dataflow/commands/simulated_run.hpp"
#include "dataflow/run/config/design.hpp"
#include "dataflow/run/config/keys.hpp"
#include "dataflow/run/events/event_file.hpp"
#include "dataflow/run/replay/retime.hpp"

namespace dataflow {

namespace {

using sweeps::PointResult;

/// Configurations and what they name are read again by each process, and may be other files than when the sweep began.
class PointCheck {
  public:
    PointCheck(sweeps::Sweep const& sweep, std::vector<sweeps::PointIdentity> const& identities)
        : sweep_(sweep), identities_(identities) {}

    /// Whether the point is another now; then trouble says so.
    bool has_changed(std::size_t point, RunConfig const& config, SweepReply& reply) {
        if (is_same(identities_[point], config))
            return false;
        reply.trouble =
            fmt::format("{}: {}: its configuration, or a file that it names, changed while the sweep was at work",
                        sweep_.file, sweeps::name_of_point(point, sweep_.columns(), sweep_.values(point)));
        return true;
    }

  private:
    bool is_same(sweeps::PointIdentity const& identity, RunConfig const& config) {
        try {
            return identifier_.identity(config).point == identity.point;
        } catch (HostError const&) {
            throw;
        } catch (InputError const&) {  // a file that is not there any more
            return false;
        }
    }

    sweeps::Sweep const& sweep_;
    std::vector<sweeps::PointIdentity> const& identities_;
    sweeps::Identifier identifier_;
};

/// What is wrong while the workload is made is the point's fault, unless it is the host's, as while it is recorded.
void simulate_point(sweeps::Assignment const& assignment, sweeps::Sweep const& sweep, PointCheck& check,
                    std::filesystem::path const& events, SweepReply& reply) {
    std::size_t const point = assignment.points.front();
    LoadedConfig const asked = sweep.configuration(point);
    LoadedConfig loaded = asked;
    std::unique_ptr<Workload> workload;
    replay::RecordedRun recorded;
    SimulationOptions options;
    options.recorded = assignment.kind == sweeps::Assignment::Kind::record ? &recorded : nullptr;
    RunStatistics run;
    try {
        workload = simulated_design().load_workload(loaded);
        if (check.has_changed(point, asked.config, reply))
            return;
        run = simulate(loaded.config, *workload, options);
    } catch (HostError const&) {
        throw;
    } catch (InputError const& error) {
        if (!check.has_changed(point, asked.config, reply))
            reply.results.emplace_back(point, sweeps::failed(error.what()));
        return;
    }
    PointResult const result = sweeps::result_of(run);
    if (assignment.kind == sweeps::Assignment::Kind::record && result.status == PointResult::Status::done) {
        write_events(io::OutputFile(events), loaded, recorded, run, assignment.function);
        reply.has_events = true;
    }
    reply.results.emplace_back(point, result);
}

/// The recorded machine with the point's timing: what a trace decides is as it was recorded.
Machine with_timing_of(LoadedConfig const& point, RunConfig recorded) {
    for (Key const& key : retiming_keys())
        key.write(recorded, key.read(point.config));
    return machine_of(recorded);
}

void retime_points(sweeps::Assignment const& assignment, sweeps::Sweep const& sweep, PointCheck& check,
                   std::filesystem::path const& events, SweepReply& reply) {
    constexpr std::chrono::milliseconds long_enough{300};
    auto const start = HostClock::now();
    try {
        events::EventFile const recorded = events::read_event_file(events);
        if (recorded.function != assignment.function)
            throw InputError(events.string() + ": was recorded of something else");
        replay::ScriptedRun const run(recorded.run);
        for (std::size_t const point : assignment.points) {
            LoadedConfig const asked = sweep.configuration(point);
            if (check.has_changed(point, asked.config, reply))
                return;
            Machine const machine = with_timing_of(asked, recorded.loaded.config);
            reply.results.emplace_back(point, sweeps::result_of(replay::retime(run, machine)));
            if (HostClock::now() - start > long_enough)
                return;
        }
    } catch (HostError const&) {
        throw;
    } catch (InputError const&) {
        reply.lost_events = true;
    }
}

}  // namespace

SweepReply work_on(sweeps::Assignment const& assignment, sweeps::Sweep const& sweep,
                   std::vector<sweeps::PointIdentity> const& identities, std::filesystem::path const& events) {
    SweepReply reply;
    PointCheck check(sweep, identities);
    try {
        if (assignment.kind == sweeps::Assignment::Kind::retime)
            retime_points(assignment, sweep, check, events, reply);
        else
            simulate_point(assignment, sweep, check, events, reply);
    } catch (InputError const& error) {
        reply.trouble = error.what();
    } catch (std::exception const& error) {
        std::size_t const point = assignment.points[reply.results.size()];
        reply.results.emplace_back(point, sweeps::failed(std::string("unexpected error: ") + error.what()));
    }
    return reply;
}

std::string to_text(SweepReply const& reply) {
    Json results = Json::array();
    for (auto const& [point, result] : reply.results)
        results.push_back({point, to_json(result)});
    Json const json{{"results", results},
                    {"has_events", reply.has_events},
                    {"lost_events", reply.lost_events},
                    {"trouble", reply.trouble}};
    return io::text_of(json);
}

SweepReply reply_from_text(std::string const& text) {
    Json const json = Json::parse(text);
    SweepReply reply;
    json.at("has_events").get_to(reply.has_events);
    json.at("lost_events").get_to(reply.lost_events);
    json.at("trouble").get_to(reply.trouble);
    for (Json const& row : json.at("results"))
        reply.results.emplace_back(row.at(0).get<std::size_t>(), row.at(1).get<sweeps::PointResult>());
    return reply;
}

Sweeper::Sweeper(SweepRequest const& request, sweeps::Sweep const& sweep,
                 std::vector<sweeps::PointIdentity> const& identities, std::vector<std::size_t> const& points,
                 sweeps::SweepFolder const& folder, sweeps::Journal<sweeps::PointResult>& journal)
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
                                   sweeps::failed(why_no_result(outcome, request_.time_limit_s, "--time-limit")));
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

}  // namespace dataflow
