#pragma once
#include "faster/data/tokens.hpp"
#include "faster/dataflow_names.hpp"
#include "modules/edge_map_builder/algorithms/edge_map_policy.hpp"

namespace faster {

/// What tokens do to the maps of an algorithm, told to those who want to know which words that accesses: mostly nobody.
/// Per sample: enter(); take(); take_last(), unless there are no tokens.
class WatchedMaps {
  public:
    void watch(datapath::MapWatch const& watch) { watch_ = watch; }
    bool is_watched() const { return watch_.edge_map != nullptr || watch_.object_map != nullptr; }

    void enter() { watch_.enter(); }

    /// Takes `current`, and all but the last of the `count` tokens of `next`: EdgeMapPolicy::take().
    template <class Maps>
    std::uint32_t take(Maps& maps, EdgeToken const& current, EdgeToken const* next, unsigned count) const {
        if (!is_watched())
            return maps.take(current, next, count);
        std::uint32_t seconds = 0;
        for (unsigned i = 0; i < count; ++i) {
            watch_.next_iteration();
            seconds |= std::uint32_t{maps.take_watched(i == 0 ? current : next[i - 1], watch_)} << i;
        }
        return seconds;
    }
    template <class Maps> bool take_last(Maps& maps, EdgeToken const& current, bool flush_last) const {
        watch_.next_iteration();
        return maps.take_last_watched(current, flush_last, watch_);
    }

  private:
    datapath::MapWatch watch_;
};

}  // namespace faster
