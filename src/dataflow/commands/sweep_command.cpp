#include "dataflow/commands/sweep_command.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fmt/format.h>
#include <map>
#include <vector>

#include "dataflow/base/files/durable_file.hpp"
#include "dataflow/base/held_signals.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/base/printable.hpp"
#include "dataflow/base/process_pool.hpp"
#include "dataflow/base/program_name.hpp"
#include "dataflow/commands/exit_codes.hpp"
#include "dataflow/commands/options.hpp"
#include "dataflow/commands/progress_line.hpp"
#include "dataflow/commands/say.hpp"
#include "dataflow/commands/sweeper.hpp"
#include "dataflow/run/config/plain_text.hpp"
#include "dataflow/tools/sweeps/journal.hpp"
#include "dataflow/tools/sweeps/manifest.hpp"
#include "dataflow/tools/sweeps/point_identity.hpp"
#include "dataflow/tools/sweeps/results_table.hpp"
#include "dataflow/tools/sweeps/shard.hpp"
#include "dataflow/tools/sweeps/sweep_file.hpp"
#include "dataflow/tools/sweeps/sweep_folder.hpp"
#include "dataflow/tools/sweeps/sweep_page.hpp"

namespace dataflow {

namespace {

using sweeps::PointResult;

bool has_failed(PointResult const& result) { return result.status == PointResult::Status::failed; }
bool is_wanted(PointResult const&) { return false; }

/// Writes table and page of a sweep, and says so. The points that failed are named on stderr. Returns the exit code.
int write_sweep_outputs(sweeps::SweepFolder const& folder, sweeps::Manifest const& manifest,
                        sweeps::Results const& results) {
    io::write_file_durably(folder.table(), sweeps::results_csv(manifest, results));
    io::write_file_durably(folder.page(), sweeps::sweep_page(manifest, results));
    std::vector<sweeps::PointWithResult> const there = sweeps::points_with_results(manifest, results);
    std::map<PointResult::Status, std::size_t> counts;
    for (sweeps::PointWithResult const& point : there)
        ++counts[point.result.status];
    std::size_t const failed = counts[PointResult::Status::failed], all = manifest.points.size();
    say("{}{} points: {} done, {} deadlocked, {} failed\nwritten: {}, {}\n",
        there.size() < all ? fmt::format("{} of ", there.size()) : "", all, counts[PointResult::Status::done],
        counts[PointResult::Status::deadlock], failed, folder.table().string(), folder.page().string());
    for (auto const& [i, result] : there)
        if (has_failed(result)) {
            warn("{}: {} points failed, the first is {}: {}\n", program_name(), failed, manifest.name(i),
                 result.message);
            return exit_failed_check;
        }
    return exit_done;
}

/// `faster-sim sweep merge`.
struct SweepMergeRequest {
    std::vector<std::string> folders;
    std::string out;  ///< folder
};

void name_missing(sweeps::Merged const& merged) {
    constexpr std::size_t most_named = 10;
    std::size_t const count = merged.missing.size();
    warn("{}: {} of {} points are missing:", program_name(), count, merged.manifest.points.size());
    for (std::size_t i = 0; i < std::min(count, most_named); ++i)
        warn("{} {}", i == 0 ? "" : ",", merged.manifest.name(merged.missing[i]));
    warn("{}; {} sweep {} --out with this folder does them\n",
         count > most_named ? fmt::format(" and {} more", count - most_named) : "", program_name(),
         merged.manifest.sweep);
}

/// Returns the exit code: exit_failed_check if points are missing, or one failed. Throws InputError on bad input.
int merge_sweeps(SweepMergeRequest const& request) {
    std::vector<std::filesystem::path> folders(request.folders.begin(), request.folders.end());
    if (sweeps::is_sweep_folder(request.out))
        folders.emplace_back(request.out);  // what is there stays
    sweeps::Merged const merged = sweeps::merged(folders);
    processes::HeldSignals const held;
    sweeps::SweepFolder folder(request.out);
    folder.adopt(merged.manifest);
    io::write_file_durably(folder.journal(), sweeps::journal_text(merged.results));
    int const code = write_sweep_outputs(folder, merged.manifest, merged.results);
    if (merged.missing.empty())
        return code;
    name_missing(merged);
    return exit_failed_check;
}

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

/// Throws InputError: the point's configuration is not valid, or a file that it names is not there.
sweeps::PointIdentity identity_of(std::size_t point, sweeps::Sweep const& sweep, sweeps::Identifier& identifier) {
    LoadedConfig const loaded = sweep.configuration(point);
    try {
        return identifier.identity(loaded.config);
    } catch (HostError const&) {
        throw;
    } catch (InputError const& error) {
        throw sweep.error_of(point, error);
    }
}

std::vector<sweeps::PointIdentity> identities_of(sweeps::Sweep const& sweep) {
    sweeps::Identifier identifier;
    std::vector<sweeps::PointIdentity> identities;
    constexpr std::size_t many = 10'000;  // take seconds
    if (sweep.points() >= many) {
        say("{} points: their configurations are read first\n", sweep.points());
        finish_saying();
    }
    ProgressLine progress("points read");
    for (std::size_t i = 0; i < sweep.points(); ++i) {
        identities.push_back(identity_of(i, sweep, identifier));
        progress.show(i + 1, sweep.points());
    }
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

void say_what_is_there(sweeps::Journal<PointResult> const& journal, std::size_t points, std::size_t pending) {
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
    sweeps::Journal<PointResult> journal(folder.journal(), request.retry_failed ? has_failed : is_wanted);
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

}  // namespace dataflow
