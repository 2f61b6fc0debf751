#include "modules/core/kept_maps.hpp"

#include <algorithm>

namespace faster {

namespace {

template <class Word> Image<Word> square(Word const* words, int side) {
    Image<Word> image(side, side);
    std::copy_n(words, image.pixels().size(), image.pixels().begin());
    return image;
}

}  // namespace

void KeptMaps::edge_maps_done(std::size_t sample, EdgeMapView const& maps) {
    if (sample >= count_)
        return;
    maps_[sample].edge_map = square(maps.edge, maps.side);
    maps_[sample].object_map = square(maps.object, maps.side);
}

void KeptMaps::depth_buffer_done(std::size_t sample, std::vector<std::uint16_t> const& depth_buffer) {
    if (sample >= count_)
        return;
    int side = 0;
    while (static_cast<std::size_t>(side) * static_cast<std::size_t>(side) < depth_buffer.size())
        ++side;
    maps_[sample].depth_buffer = square(depth_buffer.data(), side);
}

SampleMaps const* KeptMaps::of(std::size_t sample) const {
    auto const at = maps_.find(sample);
    return at == maps_.end() ? nullptr : &at->second;
}

}  // namespace faster
