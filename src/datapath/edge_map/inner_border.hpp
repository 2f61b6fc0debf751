#pragma once
#include <algorithm>
#include <vector>

#include "datapath/edge_map/edge_map_policy.hpp"
#include "datapath/edge_map/token_marks.hpp"

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
            for (int col = 0; col < side(); ++col)
                edge_[index(row, col)] = is_border(row, col) ? 1 : 0;
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

    bool is_border(int row, int col) const {
        return is_covered(row, col) && !(is_covered(row - 1, col) && is_covered(row + 1, col) &&
                                         is_covered(row, col - 1) && is_covered(row, col + 1));
    }
    bool is_covered(int row, int col) const {
        return !is_inside(row) || !is_inside(col) || object_[index(row, col)] != 0;
    }

    std::vector<std::uint8_t> edge_;
    std::vector<std::uint8_t> object_;
};

}  // namespace faster::datapath
