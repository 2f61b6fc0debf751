#include "kernel/sweeps/merge.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "kernel/base/input_error.hpp"
#include "kernel/sweeps/sweep_folder.hpp"

namespace faster::sweeps {

namespace {

namespace fs = std::filesystem;

void require_same_sweep(Manifest const& first, fs::path const& first_folder, Manifest const& other,
                        fs::path const& other_folder) {
    if (to_text(first) == to_text(other))
        return;
    std::string why = why_no_part_of(other, first);
    if (why.empty())
        why = why_no_part_of(first, other);
    throw InputError(fmt::format("{}: holds another sweep than {}{}{}, expected shards of one sweep",
                                 other_folder.string(), first_folder.string(), why.empty() ? "" : ": ", why));
}

void add(PointResult const& result, std::string const& point, fs::path const& folder, Results& results) {
    using Status = PointResult::Status;
    auto const [known, is_new] = results.try_emplace(point, result);
    if (is_new || result.status == Status::failed)
        return;
    if (known->second.status != Status::failed && !(known->second == result))
        throw InputError(
            fmt::format("{}: has another result than the folders before it for point {}, expected the same",
                        folder.string(), point));
    known->second = result;
}

}  // namespace

Merged merged(std::vector<fs::path> const& folders) {
    Merged all;
    all.manifest = read_manifest_of(folders.front());
    for (fs::path const& folder : folders) {
        require_same_sweep(all.manifest, folders.front(), read_manifest_of(folder), folder);
        for (auto const& [point, result] : read_journal(folder / "journal").results)
            add(result, point, folder, all.results);
    }
    all.missing = missing_points(all.manifest, all.results);
    return all;
}

std::vector<std::size_t> missing_points(Manifest const& manifest, Results const& results) {
    std::vector<std::size_t> missing;
    for (std::size_t i = 0; i < manifest.points.size(); ++i)
        if (results.count(manifest.points[i].id) == 0)
            missing.push_back(i);
    return missing;
}

}  // namespace faster::sweeps
