#pragma once
#include <algorithm>
#include <vector>

#include "datapath/edge_map/edge_map_policy.hpp"

namespace faster::datapath {

/// What the thesis's early designs have in common: one map of two bits per pixel, and an iteration per token.
/// `Design` derives from it and has `void take_one(EdgeToken const&)`, which is told only of tokens in the window.
template <class Design> class SingleMap : public EdgeMapPolicy {
  public:
    explicit SingleMap(int window) : EdgeMapPolicy(window), state_(pixels()), edge_(pixels()), object_(pixels()) {}

    void clear() override { std::fill(state_.begin(), state_.end(), unknown); }

    std::uint32_t take(EdgeToken const& first, EdgeToken const* rest, unsigned count) override {
        return take_each(first, rest, count, [this](EdgeToken const& token) {
            if (covers(token))
                static_cast<Design*>(this)->take_one(token);
            return std::uint32_t{0};
        });
    }

    bool take_last(EdgeToken const& token, bool /*flush_last*/) override {
        take(token, nullptr, 1);
        return false;
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

    std::uint8_t& state(int row, int col) { return state_[index(row, col)]; }

    /// An edge, unless the object is known to be there.
    void make_edge(int row, int col) {
        if (state(row, col) != no_edge)
            state(row, col) = is_edge;
    }

  private:
    std::vector<std::uint8_t> state_;
    std::vector<std::uint8_t> edge_;  ///< state_ as pictures
    std::vector<std::uint8_t> object_;
};

}  // namespace faster::datapath
