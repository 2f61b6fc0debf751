#include "dataflow/core/machine/access_pattern.hpp"

#include <algorithm>

namespace dataflow {
namespace {

std::vector<PixelOffset> widened(std::vector<PixelOffset> const& one_pixel, int lanes) {
    if (lanes == 1)
        return one_pixel;
    std::vector<PixelOffset> words;
    for (PixelOffset const offset : one_pixel)
        for (int lane = 0; lane < lanes; ++lane)
            words.push_back({offset.row, offset.col + lane});
    std::sort(words.begin(), words.end());
    words.erase(std::unique(words.begin(), words.end()), words.end());
    return words;
}

}  // namespace

AccessPattern widened(AccessPattern const& one_pixel, int lanes) {
    return {widened(one_pixel.reads, lanes), widened(one_pixel.writes, lanes)};
}

}  // namespace dataflow
