#include "tool/sweep_command.hpp"

#include <cstdio>
#include <filesystem>
#include <fmt/format.h>

#include "kernel/base/input_error.hpp"
#include "kernel/base/printable.hpp"
#include "kernel/base/process_pool.hpp"
#include "kernel/config/plain_text.hpp"
#include "kernel/sweeps/journal.hpp"
#include "kernel/sweeps/manifest.hpp"
#include "kernel/sweeps/point_identity.hpp"
#include "kernel/sweeps/shard.hpp"
#include "kernel/sweeps/sweep_file.hpp"
#include "kernel/sweeps/sweep_folder.hpp"
#include "tool/options.hpp"
#include "tool/say.hpp"
#include "tool/sweep_merge_command.hpp"
#include "tool/sweep_outputs.hpp"
#include "tool/sweeper.hpp"

namespace faster {

namespace {

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

bool has_failed(PointResult const& result) { return result.status == PointResult::Status::failed; }
bool is_wanted(PointResult const&) { return false; }

void say_what_is_there(sweeps::Journal const& journal, std::size_t points, std::size_t pending) {
    if (journal.damaged() > 0)
        say("{} rows of the journal were cut off or damaged: their points are done again\n", journal.damaged());
    if (pending < points)
        say("{} of {} points are done already\n", points - pending, points);
    std::fflush(stdout);
}

}  // namespace

int sweep(SweepRequest const& request) {
    sweeps::Shard const shard = shard_of(request.shard);
    sweeps::Sweep const sweep = sweeps::read_sweep_file(request.sweep);
    std::vector<sweeps::PointIdentity> const identities = identities_of(sweep);
    sweeps::Manifest const manifest = manifest_of(sweep, identities);
    processes::SignalWatch const watch;  // first, so that a signal comes through when the folder is in order
    sweeps::SweepFolder folder(request.out);
    folder.adopt(manifest);
    folder.prepare_events();
    sweeps::Journal journal(folder.journal(), request.retry_failed ? has_failed : is_wanted);
    std::vector<std::size_t> const points = points_of_shard(identities, shard);
    {
        Sweeper sweeper(request, sweep, identities, points, folder, journal);
        say_what_is_there(journal, points.size(), sweeper.pending());
        sweeper.work(watch);
    }
    return write_sweep_outputs(folder, manifest, journal.results());
}

Subcommand sweep_command() {
    return {
        "sweep",
        "Run a configuration in many variants, or merge what several hosts did; goes on where it was "
        "(docs/sweeps.md)",
        [](CLI::App& command) {
            auto const request = std::make_shared<SweepRequest>();
            command.add_option("sweep", request->sweep, "Sweep file (YAML); required, but for merge")
                ->type_name("SWEEP");
            command.add_option("--out", request->out, "Folder of the results; required")->type_name("DIR");
            add_jobs(command, request->jobs, "Processes at once");
            command
                .add_option("--shard", request->shard,
                            "Only part I of N parts of the same size; join them with sweep merge")
                ->type_name("I/N");
            command.add_option("--time-limit", request->time_limit_s, "Give up a point after this time (86400)")
                ->type_name("SECONDS")
                ->check(number_in(0.001, 1e9));
            command.add_flag("--retry-failed", request->retry_failed, "Do points that failed before again");
            command.add_flag("--keep-events", request->keep_events,
                             "Keep the event files, in case points are added later");
            auto const merge = std::make_shared<SweepMergeRequest>();
            CLI::App* const merge_command = command.add_subcommand("merge", "Join the folders of a sweep's shards");
            merge_command->add_option("folders", merge->folders, "Output folders of the shards")
                ->required()
                ->type_name("DIR");
            merge_command->add_option("--out", merge->out, "Folder of the whole sweep")->required()->type_name("DIR");
            std::string const tool = command.get_parent()->get_name();
            return [request, merge, tool] {  // the parser is gone by then
                if (!merge->folders.empty())
                    return merge_sweeps(*merge);
                if (request->sweep.empty() || request->out.empty())
                    throw InputError(
                        fmt::format("sweep: expected a sweep file and --out DIR (see {} sweep --help)", tool));
                return sweep(*request);
            };
        }};
}

}  // namespace faster
