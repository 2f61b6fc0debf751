#include "kernel/sweeps/shard.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace faster::sweeps {

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

}  // namespace faster::sweeps
