#pragma once
#include "modules/edge_map_builder/algorithms/edge_map_policy.hpp"
#include "modules/edge_map_builder/algorithms/edge_maps.hpp"

namespace faster::datapath {

/// Thesis 5.4 and A.2, the default: contour and object in a map each, and a second iteration for every object token of
/// the window (docs/function.md#edgemapbuilder).
class DualMap final : public EdgeMapPolicy {
  public:
    explicit DualMap(int window) : EdgeMapPolicy(window), maps_(window) {}

    void clear() override { maps_.clear(); }

    std::uint32_t take(EdgeToken const& first, EdgeToken const* rest, unsigned count) override {
        return take_each(first, rest, count, [this](EdgeToken const& token) { return maps_.mark(token); });
    }

    void take_run(int row, int first_col, int end_col, bool /*rightwards*/) override {
        set_run(row, first_col, end_col, maps_.marks().object);
    }

    /// For all tokens but the last.
    TokenMarks marks() { return maps_.marks(); }

    bool take_watched(EdgeToken const& token, MapWatch const& watch) override {
        maps_.take(token, watch);
        return take_second_if(maps_.needs_second(token), token, watch);
    }

    bool take_last_watched(EdgeToken const& token, bool flush_last, MapWatch const& watch) override {
        maps_.settle();
        maps_.take(token, watch);
        return take_second_if(flush_last && maps_.needs_second(token), token, watch);
    }

    std::uint8_t const* edge() const override { return maps_.edge(); }
    std::uint8_t const* object() const override { return maps_.object(); }

  private:
    bool take_second_if(bool is_due, EdgeToken const& token, MapWatch const& watch) {
        if (is_due) {
            watch.next_iteration();
            maps_.take_second(token, watch);
        }
        return is_due;
    }

    EdgeMaps maps_;
};

}  // namespace faster::datapath
