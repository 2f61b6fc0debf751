#include "dataflow/tools/sweeps/shard.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <set>

#include "dataflow/base/input_error.hpp"
#include "dataflow/tools/sweeps/journal.hpp"
#include "dataflow/tools/sweeps/sweep_folder.hpp"

namespace dataflow::sweeps {

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
    auto const [known, is_new] = results.try_emplace(point, result);
    if (is_new || result.status == PointResult::Status::failed)
        return;
    if (known->second.status != PointResult::Status::failed && !(known->second == result))
        throw InputError(
            fmt::format("{}: has another result than the folders before it for point {}, expected the same",
                        folder.string(), point));
    known->second = result;
}

}  // namespace

std::vector<std::size_t> points_of_shard(std::vector<PointIdentity> const& points, Shard const& shard) {
    std::map<std::string, std::size_t> functions;  // in the order of their first points
    std::set<std::string> seen;
    std::vector<std::size_t> distinct;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (seen.insert(points[i].point).second) {
            functions.try_emplace(points[i].function, functions.size());
            distinct.push_back(i);
        }
    std::stable_sort(distinct.begin(), distinct.end(), [&](std::size_t a, std::size_t b) {
        return functions.at(points[a].function) < functions.at(points[b].function);
    });
    auto const begin_of = [&](std::size_t part) {
        return distinct.begin() + static_cast<std::ptrdiff_t>(distinct.size() * part / shard.count);
    };
    return {begin_of(shard.index - 1), begin_of(shard.index)};
}

Merged merged(std::vector<fs::path> const& folders) {
    Merged all;
    all.manifest = read_manifest_of(folders.front());
    for (fs::path const& folder : folders) {
        require_same_sweep(all.manifest, folders.front(), read_manifest_of(folder), folder);
        for (auto const& [point, result] : read_journal<PointResult>(folder / "journal").results)
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

}  // namespace dataflow::sweeps
