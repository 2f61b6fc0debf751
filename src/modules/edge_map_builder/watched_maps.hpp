#pragma once
#include <algorithm>

#include "channels/token_loop.hpp"
#include "dataflow/base/each_bit.hpp"
#include "faster/data/tokens.hpp"
#include "faster/dataflow_names.hpp"
#include "modules/edge_map_builder/algorithms/edge_map_policy.hpp"

namespace faster {

/// Runs tokens through the maps of an algorithm and, if hazards are watched, reports the words that iterations access.
/// Per sample: take() until the last, unless there are no tokens; or take_group() for all.
class WatchedMaps {
  public:
    void watch(datapath::MapWatch const& watch) { watch_ = watch; }

    /// Iterations of the token loop: each takes `current` and reads the one behind it, of which `most` are at hand, so
    /// that the loop knows the end token one iteration early. Then the second iteration of the last token never runs,
    /// unless `flush_last` says so.
    template <class Maps>
    MixedIterations take(Maps& maps, EdgeToken& current, EdgeToken const* next, unsigned most, bool flush_last) const {
        auto const before_end = static_cast<unsigned>(std::find_if(next, next + most, is_end) - next);
        std::uint32_t seconds = 0;
        if (before_end > 0) {
            seconds = take_all(maps, current, next, before_end);
            current = next[before_end - 1];
        }
        if (before_end == most)
            return {most, seconds, false};
        watch_.next_iteration();
        std::uint32_t const last = maps.take_last_watched(current, flush_last, watch_) ? 1 : 0;
        return {before_end + 1, seconds | last << before_end, true};
    }

    /// An iteration that takes object pixels of a row.
    template <class Maps> void take_group(Maps& maps, PixelGroup const& group) const {
        auto const col = [&group](unsigned lane) { return group.col + static_cast<int>(lane); };
        if (!is_watched()) {
            for_each_run(group.mask,
                         [&](unsigned first, unsigned end) { maps.take_run(group.row, col(first), col(end), true); });
            return;
        }
        watch_.next_iteration();
        for_each_bit(group.mask, [&](unsigned lane) {
            maps.take_watched({group.row, static_cast<std::int16_t>(col(lane)), EdgeTokenKind::Object}, watch_);
        });
    }

  private:
    bool is_watched() const { return watch_.edge_map != nullptr || watch_.object_map != nullptr; }
    static bool is_end(EdgeToken const& token) { return token.kind == EdgeTokenKind::End; }

    /// Takes `current`, and all but the last of the `count` tokens of `next`: EdgeMapPolicy::take().
    template <class Maps>
    std::uint32_t take_all(Maps& maps, EdgeToken const& current, EdgeToken const* next, unsigned count) const {
        if (!is_watched())
            return maps.take(current, next, count);
        std::uint32_t seconds = 0;
        for (unsigned i = 0; i < count; ++i) {
            watch_.next_iteration();
            seconds |= std::uint32_t{maps.take_watched(i == 0 ? current : next[i - 1], watch_)} << i;
        }
        return seconds;
    }

    datapath::MapWatch watch_;
};

}  // namespace faster
