#include "tool/sweep_work.hpp"

#include <chrono>

#include "kernel/base/files/json_file.hpp"
#include "kernel/base/files/output_file.hpp"
#include "kernel/base/input_error.hpp"
#include "kernel/base/json.hpp"
#include "kernel/config/design.hpp"
#include "kernel/config/keys.hpp"
#include "kernel/events/event_file.hpp"
#include "kernel/replay/retime.hpp"
#include "tool/recorded_events.hpp"
#include "tool/simulated_run.hpp"

namespace faster {

namespace {

using Kind = sweeps::Assignment::Kind;
using sweeps::PointResult;

/// What is wrong while the workload is made is the point's fault, unless it is the host's, as while it is recorded.
void simulate_point(sweeps::Assignment const& assignment, sweeps::Sweep const& sweep,
                    std::filesystem::path const& events, SweepReply& reply) {
    std::size_t const point = assignment.points.front();
    LoadedConfig loaded;
    std::unique_ptr<Workload> workload;
    replay::RecordedRun recorded;
    SimulationOptions options;
    options.recorded = assignment.kind == Kind::record ? &recorded : nullptr;
    RunStatistics run;
    try {
        loaded = sweep.configuration(point);
        workload = simulated_design().load_workload(loaded);
        run = simulate(loaded.config, *workload, options);
    } catch (HostError const&) {
        throw;
    } catch (InputError const& error) {
        reply.results.emplace_back(point, sweeps::failed(error.what()));
        return;
    }
    PointResult const result = sweeps::result_of(run);
    if (assignment.kind == Kind::record && result.status == PointResult::Status::done) {
        write_events(io::OutputFile(events), loaded, recorded, run);
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

void retime_points(sweeps::Assignment const& assignment, sweeps::Sweep const& sweep,
                   std::filesystem::path const& events, SweepReply& reply) {
    constexpr std::chrono::milliseconds long_enough{300};
    auto const start = std::chrono::steady_clock::now();
    try {
        events::EventFile const recorded = events::read_event_file(events);
        replay::ScriptedRun const run(recorded.run, recorded.run.lead(machine_of(recorded.loaded.config)));
        for (std::size_t const point : assignment.points) {
            Machine const machine = with_timing_of(sweep.configuration(point), recorded.loaded.config);
            reply.results.emplace_back(point, sweeps::result_of(replay::retime(run, machine)));
            if (std::chrono::steady_clock::now() - start > long_enough)
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
                   std::filesystem::path const& events) {
    SweepReply reply;
    try {
        if (assignment.kind == Kind::retime)
            retime_points(assignment, sweep, events, reply);
        else
            simulate_point(assignment, sweep, events, reply);
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
        reply.results.emplace_back(row.at(0).get<std::size_t>(), sweeps::result_from_json(row.at(1)));
    return reply;
}

}  // namespace faster
