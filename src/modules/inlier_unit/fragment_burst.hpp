#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "faster/data/tokens.hpp"
#include "faster/dataflow_names.hpp"
#include "modules/core/depth.hpp"

namespace faster {

/// Fragments at hand, and the command behind each.
struct FragmentBurst {
    std::int64_t const* z_sum;
    FragmentIndex const* index;
    Command const* next;
    std::size_t size;
    std::uint64_t reciprocal;  ///< of their triangle's area

    /// Draws them into a window of `side` x `side` words while `command`, which is read one ahead, is Fragment: thesis
    /// A.3. What lies outside is dropped. Returns how many were taken; `drawn` grows by those that passed the depth
    /// test. `watcher` is told of the words: a WriteDistances, or NoWriteDistances.
    template <class Watcher>
    std::size_t draw(datapath::DepthUnit const& unit, std::uint16_t* words, unsigned side, Command& command,
                     std::uint64_t& drawn, Watcher& watcher) const {
        std::uint64_t passed = 0;
        std::size_t n = 0;
        for (; n < size && command == Command::Fragment; ++n) {
            watcher.next_iteration();
            auto const row = static_cast<unsigned>(int{index[n].row});
            auto const col = static_cast<unsigned>(int{index[n].col});
            if (row < side && col < side) {
                std::uint64_t const depth = unit.fragment_depth(static_cast<std::uint64_t>(z_sum[n]), reciprocal);
                std::size_t const word = std::size_t{row} * side + col;
                bool const is_drawn = unit.draw(depth, words[word]);
                watcher.read(word);
                if (is_drawn)
                    watcher.overwrite(word);
                passed += is_drawn ? 1U : 0U;
            }
            command = next[n];
        }
        drawn += passed;
        return n;
    }
};

}  // namespace faster
