#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>

#include "faster/config/edge_map_config.hpp"
#include "faster/data/tokens.hpp"
#include "modules/edge_map_builder/algorithms/map_watch.hpp"

namespace faster::datapath {

/// One way to turn the edge tokens of a sample into its edge map. A policy says what the tokens do to its maps, and how
/// many iterations of the token loop that takes; how long an iteration takes is not its business.
///
/// Per sample: clear(); take() for any tokens but the last; take_last(), unless there are none; finish(). Then edge()
/// and object() hold, until the next clear(). Tokens outside the window take an iteration and do nothing.
class EdgeMapPolicy {
  public:
    /// `window`: side of the maps [px]
    explicit EdgeMapPolicy(int window) : side_(static_cast<unsigned>(window)) {}
    virtual ~EdgeMapPolicy() = default;
    EdgeMapPolicy(EdgeMapPolicy const&) = delete;
    EdgeMapPolicy& operator=(EdgeMapPolicy const&) = delete;

    virtual void clear() = 0;

    /// All iterations of `count` tokens, 1 to 32: `first`, then rest[0] to rest[count - 2]. Bit i of the result says
    /// that the i-th token took a second iteration, one that consumes no token.
    virtual std::uint32_t take(EdgeToken const& first, EdgeToken const* rest, unsigned count) = 0;

    /// take() of object tokens side by side: columns [first_col, end_col) of a row, from the left if `rightwards`.
    virtual void take_run(int row, int first_col, int end_col, bool rightwards);

    /// The iterations of the last token. The end token is read while it is consumed, and thesis A.2 leaves the loop
    /// with it: a second iteration only runs with `flush_last`. True if there was one.
    bool take_last(EdgeToken const& token, bool flush_last) { return take_last_watched(token, flush_last, {}); }

    /// take() of one token, and take_last(), with what their iterations access. `watch` has been told of the first
    /// iteration, and is told of the second.
    virtual bool take_watched(EdgeToken const& token, MapWatch const& watch) = 0;
    virtual bool take_last_watched(EdgeToken const& token, bool flush_last, MapWatch const& watch) = 0;

    /// Called once after all tokens, before anybody looks at the maps.
    virtual void finish() {}

    /// Rows that the output loop has read when it sends the first bit.
    virtual std::size_t rows_read_ahead() const { return 0; }

    /// W x W bytes, 0 or 1, row by row: the contour, which leaves; and the pixels known to be no contour because the
    /// object covers them.
    virtual std::uint8_t const* edge() const = 0;
    virtual std::uint8_t const* object() const = 0;
    int side() const { return static_cast<int>(side_); }

  protected:
    bool covers(EdgeToken const& token) const { return is_inside(token.row) && is_inside(token.col); }
    bool is_inside(int coordinate) const { return static_cast<unsigned>(coordinate) < side_; }
    std::size_t pixels() const { return std::size_t{side_} * side_; }
    std::size_t index(int row, int col) const {
        return static_cast<std::size_t>(row) * side_ + static_cast<std::size_t>(col);
    }

    /// take() by a function that takes one token and returns 1 if it needed a second iteration, else 0.
    template <class TakeOne>
    static std::uint32_t take_each(EdgeToken const& first, EdgeToken const* rest, unsigned count, TakeOne take_one) {
        std::uint32_t seconds = take_one(first);
        for (unsigned i = 1; i < count; ++i)
            seconds |= take_one(rest[i - 1]) << i;
        return seconds;
    }

    /// Sets those pixels of a map that lie in the window.
    void set_run(int row, int first_col, int end_col, std::uint8_t* map) const {
        int const from = std::max(first_col, 0);
        int const to = std::min(end_col, side());
        if (!is_inside(row) || from >= to)
            return;
        std::uint8_t* next = map + index(row, from);
        std::uint8_t* const end = next + (to - from);
        for (; end - next >= 8; next += 8)  // runs are short: no call
            std::memset(next, 1, 8);
        for (; next != end; ++next)
            *next = 1;
    }

  private:
    unsigned side_;
};

std::unique_ptr<EdgeMapPolicy> make_edge_map_policy(EdgeMapAlgorithm algorithm, int window);

}  // namespace faster::datapath
