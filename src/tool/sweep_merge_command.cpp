#include "tool/sweep_merge_command.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>

#include "kernel/base/files/durable_file.hpp"
#include "kernel/base/held_signals.hpp"
#include "kernel/base/program_name.hpp"
#include "kernel/sweeps/merge.hpp"
#include "kernel/sweeps/sweep_folder.hpp"
#include "tool/exit_codes.hpp"
#include "tool/say.hpp"
#include "tool/sweep_outputs.hpp"

namespace faster {

namespace {

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

}  // namespace

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

}  // namespace faster
