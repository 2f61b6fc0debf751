#pragma once
#include <algorithm>
#include <vector>

#include "modules/edge_map_builder/algorithms/edge_map_policy.hpp"

namespace faster::datapath {

/// Thesis 4.1.2: two maps as in A.2, but the iteration that consumes an object token writes its bit at once. So only
/// tokens with an uncovered pixel above or below take a second iteration, which makes edges of these.
class DualMapFirstWrite final : public EdgeMapPolicy {
  public:
    explicit DualMapFirstWrite(int window) : EdgeMapPolicy(window), edge_(pixels()), object_(pixels()) {}

    void clear() override {
        std::fill(edge_.begin(), edge_.end(), std::uint8_t{0});
        std::fill(object_.begin(), object_.end(), std::uint8_t{0});
    }

    std::uint32_t take(EdgeToken const& first, EdgeToken const* rest, unsigned count) override {
        return take_each(first, rest, count, [this](EdgeToken const& token) -> std::uint32_t {
            if (!take_first(token, NoMapWatch()))
                return 0;
            take_second(token, NoMapWatch());
            return 1;
        });
    }

    bool take_watched(EdgeToken const& token, MapWatch const& watch) override {
        return take_last_watched(token, true, watch);
    }

    bool take_last_watched(EdgeToken const& token, bool flush_last, MapWatch const& watch) override {
        bool const second = take_first(token, watch) && flush_last;
        if (second) {
            watch.next_iteration();
            take_second(token, watch);
        }
        return second;
    }

    std::uint8_t const* edge() const override { return edge_.data(); }
    std::uint8_t const* object() const override { return object_.data(); }

  private:
    /// The iteration that consumes the token. True if a second is due.
    template <class Watch> bool take_first(EdgeToken const& token, Watch const& watch) {
        if (!covers(token))
            return false;
        std::size_t const pixel = index(token.row, token.col);
        if (token.kind != EdgeTokenKind::Object) {
            watch.reads_object(pixel);
            if (object_[pixel] == 0)
                make_edge(pixel, watch);
            return false;
        }
        object_[pixel] = 1;
        edge_[pixel] = 0;
        watch.writes_object(pixel);
        watch.writes_edge(pixel);
        for (int const row : {token.row + 1, token.row - 1})
            if (is_inside(row))
                watch.reads_object(index(row, token.col));
        return is_uncovered(token.row + 1, token.col) || is_uncovered(token.row - 1, token.col);
    }

    /// Nothing has written in between, so what is due can be looked at again.
    template <class Watch> void take_second(EdgeToken const& token, Watch const& watch) {
        for (int const row : {token.row - 1, token.row + 1})
            if (is_uncovered(row, token.col))
                make_edge(index(row, token.col), watch);
    }

    template <class Watch> void make_edge(std::size_t pixel, Watch const& watch) {
        edge_[pixel] = 1;
        watch.writes_edge(pixel);
    }

    bool is_uncovered(int row, int col) const { return is_inside(row) && object_[index(row, col)] == 0; }

    std::vector<std::uint8_t> edge_;
    std::vector<std::uint8_t> object_;
};

}  // namespace faster::datapath
