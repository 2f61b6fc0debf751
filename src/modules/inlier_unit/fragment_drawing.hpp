#pragma once
#include <cstddef>
#include <cstdint>

#include "dataflow/base/each_bit.hpp"
#include "faster/data/tokens.hpp"
#include "faster/dataflow_names.hpp"
#include "modules/core/depth.hpp"

namespace faster {

/// Fragments of a triangle on their way into a depth buffer of `side` x `side` words: thesis A.3.
struct FragmentDrawing {
    datapath::DepthUnit unit;
    std::uint16_t* words;
    unsigned side;
    std::uint64_t reciprocal;  ///< of the triangle's area

    /// True if it passes the depth test. What lies outside is dropped. `watcher` is told of the words: a
    /// WriteDistances, or NoWriteDistances.
    template <class Watcher> bool draw(std::int64_t z_sum, FragmentIndex const& pixel, Watcher& watcher) const {
        auto const row = static_cast<unsigned>(int{pixel.row});
        auto const col = static_cast<unsigned>(int{pixel.col});
        if (row >= side || col >= side)
            return false;
        std::uint64_t const depth = unit.fragment_depth(static_cast<std::uint64_t>(z_sum), reciprocal);
        std::size_t const word = std::size_t{row} * side + col;
        bool const is_drawn = unit.draw(depth, words[word]);
        watcher.read(word);
        if (is_drawn)
            watcher.write(word);
        return is_drawn;
    }
    /// Pixels of a row, one by one. Returns how many were drawn.
    template <class Watcher>
    unsigned draw_group(DepthGroup const& depths, PixelGroup const& pixels, Watcher& watcher) const {
        unsigned drawn = 0;
        for_each_bit(pixels.mask, [&](unsigned lane) {
            std::int64_t const z_sum = depths.z_sum + std::int64_t{lane} * depths.z_sum_per_column;
            FragmentIndex const pixel{pixels.row, static_cast<std::int16_t>(pixels.col + static_cast<int>(lane))};
            drawn += draw(z_sum, pixel, watcher) ? 1U : 0U;
        });
        return drawn;
    }
};

}  // namespace faster
