#pragma once
#include <algorithm>
#include <vector>

#include "modules/edge_map_builder/algorithms/edge_map_policy.hpp"

namespace faster::datapath {

/// What the thesis's early designs have in common: one map of two bits per pixel, and an iteration per token.
/// `Design` derives from it and has `void take_one(EdgeToken const&, Watch const&)`, a template over watches, which is
/// told only of tokens in the window.
template <class Design> class SingleMap : public EdgeMapPolicy {
  public:
    explicit SingleMap(int window) : EdgeMapPolicy(window), state_(pixels()), edge_(pixels()), object_(pixels()) {}

    void clear() override { std::fill(state_.begin(), state_.end(), unknown); }

    std::uint32_t take(EdgeToken const& first, EdgeToken const* rest, unsigned count) override {
        return take_each(first, rest, count, [this](EdgeToken const& token) {
            if (covers(token))
                static_cast<Design*>(this)->take_one(token, NoMapWatch());
            return std::uint32_t{0};
        });
    }

    bool take_watched(EdgeToken const& token, MapWatch const& watch) override {
        if (covers(token))
            static_cast<Design*>(this)->take_one(token, watch);
        return false;
    }

    bool take_last_watched(EdgeToken const& token, bool /*flush_last*/, MapWatch const& watch) override {
        return take_watched(token, watch);
    }

    void finish() override {
        for (std::size_t i = 0; i < state_.size(); ++i) {
            edge_[i] = state_[i] == is_edge ? 1 : 0;
            object_[i] = state_[i] == no_edge ? 1 : 0;
        }
    }

    std::uint8_t const* edge() const override { return edge_.data(); }
    std::uint8_t const* object() const override { return object_.data(); }

  protected:
    // The values of the map (thesis 5.1, 5.2).
    static constexpr std::uint8_t unknown = 0;
    static constexpr std::uint8_t is_edge = 1;
    static constexpr std::uint8_t no_edge = 2;

    template <class Watch> void write(int row, int col, std::uint8_t state, Watch const& watch) {
        state_[index(row, col)] = state;
        watch.writes_edge(index(row, col));
    }

    template <class Watch> std::uint8_t read(int row, int col, Watch const& watch) const {
        watch.reads_edge(index(row, col));
        return state_[index(row, col)];
    }

    /// An edge, unless the object is known to be there.
    template <class Watch> void make_edge(int row, int col, Watch const& watch) {
        if (read(row, col, watch) != no_edge)
            write(row, col, is_edge, watch);
    }

  private:
    std::vector<std::uint8_t> state_;
    std::vector<std::uint8_t> edge_;  ///< state_ as pictures
    std::vector<std::uint8_t> object_;
};

}  // namespace faster::datapath
