#include "modules/edge_map_builder/algorithms/edge_maps.hpp"

#include <algorithm>

namespace faster::datapath {

EdgeMaps::EdgeMaps(int window)
    : side_(static_cast<unsigned>(window)),
      bytes_(2 * std::size_t{side_ + 2} * side_),
      map_{bytes_.data(), bytes_.data() + bytes_.size() / 2} {}

void EdgeMaps::clear() { std::fill(bytes_.begin(), bytes_.end(), std::uint8_t{0}); }

void EdgeMaps::take(EdgeToken const& token, MapWatch const& watch) {
    if (!covers(token))
        return;
    if (token.kind != EdgeTokenKind::Object) {
        watch.reads_object(word(token.row, token.col));
        mark_uncovered(token.row, token.col, watch);
        return;
    }
    map_[0][index(token.row, token.col)] = 0;
    watch.writes_edge(word(token.row, token.col));
    for (int const row : {token.row + 1, token.row - 1})
        if (is_inside(row))
            watch.reads_object(word(row, token.col));
}

void EdgeMaps::take_second(EdgeToken const& token, MapWatch const& watch) {
    map_[1][index(token.row, token.col)] = 1;
    watch.writes_object(word(token.row, token.col));
    for (int const row : {token.row + 1, token.row - 1})
        if (is_inside(row))
            mark_uncovered(row, token.col, watch);
}

void EdgeMaps::mark_uncovered(int row, int col, MapWatch const& watch) {
    if (map_[1][index(row, col)] != 0)
        return;
    map_[0][index(row, col)] = 1;
    watch.writes_edge(word(row, col));
}

void EdgeMaps::settle() {
    std::size_t const row = side_;
    std::uint8_t* const edge = map_[0];
    std::uint8_t const* const object = map_[1];
    for (std::size_t i = row; i < row + row * row; ++i)
        edge[i] = static_cast<std::uint8_t>((edge[i] | object[i - row] | object[i + row]) & (object[i] ^ 1U));
}

}  // namespace faster::datapath
