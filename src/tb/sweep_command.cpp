#include "tb/sweep_command.hpp"

#include <filesystem>
#include <fmt/format.h>
#include <map>
#include <set>
#include <thread>

#include "common/input_error.hpp"
#include "config/plain_text.hpp"
#include "processes/process_pool.hpp"
#include "sweeps/journal.hpp"
#include "sweeps/manifest.hpp"
#include "sweeps/point_identity.hpp"
#include "sweeps/schedule.hpp"
#include "sweeps/shard.hpp"
#include "sweeps/sweep_file.hpp"
#include "sweeps/sweep_folder.hpp"
#include "tb/budget_run.hpp"
#include "tb/progress_line.hpp"
#include "tb/sweep_outputs.hpp"
#include "tb/sweep_work.hpp"

namespace faster {

namespace {

using sweeps::Assignment;
using sweeps::PointResult;

sweeps::Shard shard_of(std::string const& text) {
    if (text.empty())
        return {};
    std::size_t const slash = text.find('/');
    auto const index = parse_integer(text.substr(0, slash));
    auto const count = slash == std::string::npos ? std::nullopt : parse_integer(text.substr(slash + 1));
    if (!index || !count || *index < 1 || *index > *count)
        throw InputError(fmt::format("--shard {}: expected I/N with I from 1 to N, such as 2/8", shortened(text)));
    return {static_cast<std::size_t>(*index), static_cast<std::size_t>(*count)};
}

std::vector<sweeps::PointIdentity> identities_of(sweeps::Sweep const& sweep) {
    sweeps::Identifier identifier;
    std::vector<sweeps::PointIdentity> identities;
    for (std::size_t i = 0; i < sweep.points(); ++i)
        identities.push_back(identifier.identity(sweep.configuration(i).config));
    return identities;
}

sweeps::Manifest manifest_of(sweeps::Sweep const& sweep, std::vector<sweeps::PointIdentity> const& identities) {
    sweeps::Manifest manifest;
    manifest.sweep = std::filesystem::path(sweep.file).filename().string();
    manifest.version = FASTER_VERSION;
    manifest.columns = sweep.columns();
    for (std::size_t i = 0; i < identities.size(); ++i)
        manifest.points.push_back({identities[i].point, sweep.values(i)});
    return manifest;
}

/// Lets processes do the points of a sweep that have no result yet, and writes results down as they come.
class Sweeper {
  public:
    Sweeper(SweepRequest const& request, sweeps::Sweep const& sweep,
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

    void work(processes::SignalWatch const& watch) {
        processes::TaskStream stream;
        stream.next = [this](std::size_t number) { return next(number); };
        stream.ended = [this](std::size_t number, processes::Outcome const& outcome) { ended(number, outcome); };
        processes::run_stream(stream, processes(), watch);
        remove_event_files();
    }
    std::size_t pending() const { return pending_.size(); }

  private:
    std::size_t processes() const {
        return request_.jobs > 0 ? static_cast<std::size_t>(request_.jobs)
                                 : std::max(1U, std::thread::hardware_concurrency());
    }

    std::vector<sweeps::Schedule::Job> pending_of(std::vector<std::size_t> const& points) const {
        std::vector<sweeps::Schedule::Job> pending;
        for (std::size_t const point : points)
            if (journal_.results().count(identities_[point].point) == 0)
                pending.push_back({point, identities_[point].function});
        return pending;
    }

    /// Whether a file is whole is found out by the process that reads it.
    std::set<std::string> recorded_functions() const {
        std::set<std::string> functions;
        for (sweeps::Schedule::Job const& job : pending_)
            if (std::filesystem::exists(folder_.events(job.function)))
                functions.insert(job.function);
        return functions;
    }

    std::optional<processes::Task> next(std::size_t number) {
        auto const assignment = schedule_.next(processes());
        if (!assignment)
            return std::nullopt;
        at_work_[number] = *assignment;
        std::filesystem::path const events = folder_.events(assignment->function);
        return processes::Task{[this, given = *assignment, events] { return to_text(work_on(given, sweep_, events)); },
                               request_.time_limit_s};
    }

    void ended(std::size_t number, processes::Outcome const& outcome) {
        Assignment const assignment = at_work_.at(number);
        at_work_.erase(number);
        SweepReply const reply = reply_of(assignment, outcome);
        write_down(reply);
        if (!reply.trouble.empty())
            throw InputError(reply.trouble);
        sweeps::Ending ending{{}, reply.has_events, reply.lost_events, outcome.kind != processes::Outcome::Kind::done};
        for (auto const& [point, result] : reply.results)
            ending.done.push_back(point);
        std::filesystem::path const events = folder_.events(assignment.function);
        if (reply.lost_events)
            std::filesystem::remove(events);
        schedule_.ended(assignment, ending);
        if (schedule_.is_finished(assignment.function) && !request_.keep_events)
            std::filesystem::remove(events);
        done_ += reply.results.size();
        progress_.show(done_, all_);
    }

    /// A process that got lost with several points says nothing about any of them: they are done again, one by one.
    SweepReply reply_of(Assignment const& assignment, processes::Outcome const& outcome) const {
        if (outcome.kind == processes::Outcome::Kind::done)
            return reply_from_text(outcome.output);
        SweepReply reply;
        if (assignment.points.size() == 1)
            reply.results.emplace_back(assignment.points.front(),
                                       sweeps::failed(why_no_result(outcome, request_.time_limit_s)));
        return reply;
    }

    void write_down(SweepReply const& reply) {
        std::vector<std::pair<std::string, PointResult>> rows;
        for (auto const& [point, result] : reply.results)
            rows.emplace_back(identities_[point].point, result);
        if (!rows.empty())
            journal_.append(rows);
    }

    /// Those of functions that were done before, by a process that was ended between its last row and this.
    void remove_event_files() const {
        if (request_.keep_events)
            return;
        for (sweeps::PointIdentity const& identity : identities_)
            std::filesystem::remove(folder_.events(identity.function));
        folder_.remove_events_folder();
    }

    SweepRequest const& request_;
    sweeps::Sweep const& sweep_;
    std::vector<sweeps::PointIdentity> const& identities_;
    sweeps::SweepFolder const& folder_;
    sweeps::Journal& journal_;
    std::size_t all_;
    std::vector<sweeps::Schedule::Job> pending_;
    sweeps::Schedule schedule_;
    std::size_t done_;
    ProgressLine progress_;
    std::map<std::size_t, Assignment> at_work_;
};

bool has_failed(PointResult const& result) { return result.status == PointResult::Status::failed; }
bool is_wanted(PointResult const&) { return false; }

void say_what_is_there(sweeps::Journal const& journal, std::size_t points, std::size_t pending) {
    if (journal.damaged() > 0)
        fmt::print("{} rows of the journal were cut off or damaged: their points are done again\n", journal.damaged());
    if (pending < points)
        fmt::print("{} of {} points are done already\n", points - pending, points);
    std::fflush(stdout);
}

}  // namespace

int sweep(SweepRequest const& request) {
    sweeps::Shard const shard = shard_of(request.shard);
    sweeps::Sweep const sweep = sweeps::read_sweep_file(request.sweep);
    std::vector<sweeps::PointIdentity> const identities = identities_of(sweep);
    sweeps::Manifest const manifest = manifest_of(sweep, identities);
    sweeps::SweepFolder folder(request.out);
    folder.adopt(manifest);
    folder.prepare_events();
    sweeps::Journal journal(folder.journal(), request.retry_failed ? has_failed : is_wanted);
    std::vector<std::size_t> const points = points_of_shard(identities, shard);
    {
        processes::SignalWatch const watch;
        Sweeper sweeper(request, sweep, identities, points, folder, journal);
        say_what_is_there(journal, points.size(), sweeper.pending());
        sweeper.work(watch);
    }
    return write_sweep_outputs(folder, manifest, journal.results());
}

}  // namespace faster
