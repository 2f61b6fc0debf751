#include "tb/edge_map_judge.hpp"

#include <algorithm>

#include "datapath/edge_map/edge_map_policy.hpp"

namespace faster {

void EdgeMapJudge::edge_maps_done(std::size_t sample, datapath::EdgeMapPolicy const& maps) {
    if (sample >= count_)
        return;
    Image<std::uint8_t> edge_map(maps.side(), maps.side());
    std::copy_n(maps.edge(), edge_map.pixels().size(), edge_map.pixels().begin());
    sums_.add(judge_.judge(sample, edge_map));
}

}  // namespace faster
