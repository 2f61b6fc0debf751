#pragma once
#include <algorithm>
#include <vector>

#include "modules/edge_map_builder/algorithms/edge_map_policy.hpp"
#include "modules/edge_map_builder/algorithms/token_marks.hpp"

namespace faster::datapath {

/// Thesis 7.2: the contour is the border of the object itself. Which covered pixels are border is not known before all
/// of them are, so tokens only mark what is covered; the output loop compares each pixel with its four neighbours. It
/// keeps the last two rows it has read, and so reads one pixel per iteration and runs a row ahead of what it sends.
/// Beyond the window the object is taken to go on, as in A.2: where the window cuts it there is no contour.
class InnerBorder final : public EdgeMapPolicy {
  public:
    explicit InnerBorder(int window) : EdgeMapPolicy(window), edge_(pixels()), object_(pixels()) {}

    void clear() override { std::fill(object_.begin(), object_.end(), std::uint8_t{0}); }

    std::uint32_t take(EdgeToken const& first, EdgeToken const* rest, unsigned count) override {
        return take_each(first, rest, count, [this](EdgeToken const& token) {
            take_one(token, NoMapWatch());
            return std::uint32_t{0};
        });
    }

    void take_run(int row, int first_col, int end_col, bool /*rightwards*/) override {
        set_run(row, first_col, end_col, object_.data());
    }

    /// For all tokens; those of edges say nothing, and finish() writes over them.
    TokenMarks marks() { return {edge_.data(), object_.data()}; }

    bool take_watched(EdgeToken const& token, MapWatch const& watch) override {
        take_one(token, watch);
        return false;
    }

    bool take_last_watched(EdgeToken const& token, bool /*flush_last*/, MapWatch const& watch) override {
        return take_watched(token, watch);
    }

    void finish() override {
        for (int row = 0; row < side(); ++row)
            find_border_in(row);
    }

    std::size_t rows_read_ahead() const override { return 1; }

    std::uint8_t const* edge() const override { return edge_.data(); }
    std::uint8_t const* object() const override { return object_.data(); }

  private:
    template <class Watch> void take_one(EdgeToken const& token, Watch const& watch) {
        if (token.kind != EdgeTokenKind::Object || !covers(token))
            return;
        object_[index(token.row, token.col)] = 1;
        watch.writes_object(index(token.row, token.col));
    }

    /// A pixel that stands for a neighbour outside the window is covered wherever it could be border.
    void find_border_in(int row) {
        int const last = side() - 1;
        std::uint8_t const* const here = &object_[index(row, 0)];
        std::uint8_t const* const above = row > 0 ? here - side() : here;
        std::uint8_t const* const below = row < last ? here + side() : here;
        std::uint8_t* const edge = &edge_[index(row, 0)];
        auto const find = [=](int col, int left, int right) {
            auto const inner = static_cast<unsigned>(above[col] & below[col] & here[left] & here[right]);
            edge[col] = static_cast<std::uint8_t>(here[col] & (inner ^ 1U));
        };
        find(0, 0, std::min(1, last));
        for (int col = 1; col < last; ++col)
            find(col, col - 1, col + 1);
        find(last, std::max(0, last - 1), last);
    }

    std::vector<std::uint8_t> edge_;
    std::vector<std::uint8_t> object_;
};

}  // namespace faster::datapath
