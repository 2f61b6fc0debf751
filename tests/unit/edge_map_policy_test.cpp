#include "modules/edge_map_builder/algorithms/edge_map_policy.hpp"

#include <catch2/catch.hpp>
#include <random>
#include <string>
#include <vector>

#include "faster/data/image.hpp"
#include "faster/reference/edge_map/bounded.hpp"
#include "faster/reference/edge_map/dual_map.hpp"
#include "faster/reference/edge_map/dual_map_4_1_2.hpp"
#include "faster/reference/edge_map/inner_border.hpp"
#include "faster/reference/edge_map/threshold.hpp"
#include "faster/reference/edge_map/transition.hpp"

namespace faster::datapath::edge_map_policy_test {

using Tokens = std::vector<EdgeToken>;
using Rows = std::vector<std::string>;

EdgeToken object(int row, int col) {
    return {static_cast<std::int16_t>(row), static_cast<std::int16_t>(col), EdgeTokenKind::Object};
}
EdgeToken edge(int row, int col) {
    return {static_cast<std::int16_t>(row), static_cast<std::int16_t>(col), EdgeTokenKind::Edge};
}

/// One bit per token: whether it took a second iteration.
std::vector<bool> feed(EdgeMapPolicy& policy, Tokens const& tokens, bool flush_last = false) {
    policy.clear();
    std::vector<bool> seconds;
    if (tokens.empty()) {
        policy.finish();
        return seconds;
    }
    for (std::size_t i = 0; i + 1 < tokens.size();) {
        auto const count = static_cast<unsigned>(std::min<std::size_t>(tokens.size() - 1 - i, 32));
        std::uint32_t const bits = policy.take(tokens[i], tokens.data() + i + 1, count);
        for (unsigned k = 0; k < count; ++k)
            seconds.push_back((bits >> k & 1U) != 0);
        i += count;
    }
    seconds.push_back(policy.take_last(tokens.back(), flush_last));
    policy.finish();
    return seconds;
}

/// `#` contour, `o` object.
Rows picture_of(EdgeMapPolicy const& policy) {
    Rows rows;
    auto const side = static_cast<std::size_t>(policy.side());
    for (std::size_t i = 0; i < side * side; ++i) {
        if (i % side == 0)
            rows.emplace_back();
        rows.back() += policy.edge()[i] != 0 ? '#' : policy.object()[i] != 0 ? 'o' : '.';
    }
    return rows;
}

Rows drawn(EdgeMapAlgorithm algorithm, int window, Tokens const& tokens) {
    auto const policy = make_edge_map_policy(algorithm, window);
    feed(*policy, tokens);
    return picture_of(*policy);
}

/// What A.1 sends for a block of 3 x 3 at (1, 2): entered from the left, the right, the left.
Tokens const block{object(1, 2), edge(1, 1), object(1, 3), object(1, 4), edge(1, 5),
                   object(2, 4), edge(2, 5), object(2, 3), object(2, 2), edge(2, 1),
                   object(3, 2), edge(3, 1), object(3, 3), object(3, 4), edge(3, 5)};

TEST_CASE("Transition misses the contour along rows", "[edge_map]") {
    CHECK(drawn(EdgeMapAlgorithm::transition, 7, block) == Rows{".......",  //
                                                                ".#ooo#.",  //
                                                                ".#ooo#.",  //
                                                                ".#ooo#.",  //
                                                                ".......",  //
                                                                ".......",  //
                                                                "......."});
}

TEST_CASE("Bounded and both dual maps close the contour", "[edge_map]") {
    for (EdgeMapAlgorithm const algorithm :
         {EdgeMapAlgorithm::bounded, EdgeMapAlgorithm::dual_map, EdgeMapAlgorithm::dual_map_4_1_2})
        CHECK(drawn(algorithm, 7, block) == Rows{"..###..",  //
                                                 ".#ooo#.",  //
                                                 ".#ooo#.",  //
                                                 ".#ooo#.",  //
                                                 "..###..",  //
                                                 ".......",  //
                                                 "......."});
}

TEST_CASE("The inner border is the object's own outline", "[edge_map]") {
    CHECK(drawn(EdgeMapAlgorithm::inner_border, 7, block) == Rows{".......",  //
                                                                  "..###..",  //
                                                                  "..#o#..",  //
                                                                  "..###..",  //
                                                                  ".......",  //
                                                                  ".......",  //
                                                                  "......."});
}

TEST_CASE("Where the window cuts the object there is no inner border", "[edge_map]") {
    CHECK(drawn(EdgeMapAlgorithm::inner_border, 3,
                {object(0, 0), object(0, 1), object(1, 0), object(1, 1), object(2, 0), object(2, 1)}) == Rows{"o#.",  //
                                                                                                              "o#.",  //
                                                                                                              "o#."});
}

TEST_CASE("Threshold keeps what was seen once: the outside of two shapes that share a side", "[edge_map]") {
    Tokens outlines;
    for (int const left : {0, 3})
        for (int row = 0; row < 4; ++row)
            for (int col = left; col < left + 4; ++col)
                if (row == 0 || row == 3 || col == left || col == left + 3)
                    outlines.push_back(edge(row, col));
    CHECK(drawn(EdgeMapAlgorithm::threshold, 7, outlines) == Rows{"###o###",  //
                                                                  "#..o..#",  //
                                                                  "#..o..#",  //
                                                                  "###o###",  //
                                                                  ".......",  //
                                                                  ".......",  //
                                                                  "......."});
    // The corner of a third shape ends at the seam: what is no edge stays none.
    outlines.push_back(edge(3, 3));
    CHECK(drawn(EdgeMapAlgorithm::threshold, 7, outlines)[3] == "###o###");
}

TEST_CASE("Iterations of the token loop", "[edge_map]") {
    auto const seconds = [](EdgeMapAlgorithm algorithm, Tokens const& tokens) {
        auto const policy = make_edge_map_policy(algorithm, 7);
        std::vector<bool> const bits = feed(*policy, tokens);
        return std::count(bits.begin(), bits.end(), true);
    };
    Tokens twice = block;
    twice.insert(twice.end(), block.begin(), block.end());
    CHECK(seconds(EdgeMapAlgorithm::dual_map, block) == 9);
    CHECK(seconds(EdgeMapAlgorithm::dual_map, twice) == 18);
    // The first time the pixel below is never covered yet; the second time those of the middle row are between others.
    CHECK(seconds(EdgeMapAlgorithm::dual_map_4_1_2, block) == 9);
    CHECK(seconds(EdgeMapAlgorithm::dual_map_4_1_2, twice) == 15);
    for (EdgeMapAlgorithm const algorithm : {EdgeMapAlgorithm::threshold, EdgeMapAlgorithm::transition,
                                             EdgeMapAlgorithm::bounded, EdgeMapAlgorithm::inner_border})
        CHECK(seconds(algorithm, twice) == 0);
}

TEST_CASE("A due second iteration is cut off by the end token unless flush_last", "[edge_map]") {
    Tokens const one{object(1, 1)};
    auto const dual = make_edge_map_policy(EdgeMapAlgorithm::dual_map, 3);
    auto const first_write = make_edge_map_policy(EdgeMapAlgorithm::dual_map_4_1_2, 3);
    CHECK(feed(*dual, one) == std::vector<bool>{false});
    CHECK(picture_of(*dual) == Rows{"...", "...", "..."});
    CHECK(feed(*first_write, one) == std::vector<bool>{false});
    CHECK(picture_of(*first_write) == Rows{"...", ".o.", "..."});
    for (EdgeMapPolicy* const policy : {dual.get(), first_write.get()}) {
        CHECK(feed(*policy, one, true) == std::vector<bool>{true});
        CHECK(picture_of(*policy) == Rows{".#.", ".o.", ".#."});
    }
}

TEST_CASE("Only the inner border is known a row late", "[edge_map]") {
    for (EdgeMapAlgorithm const algorithm :
         {EdgeMapAlgorithm::threshold, EdgeMapAlgorithm::transition, EdgeMapAlgorithm::bounded,
          EdgeMapAlgorithm::dual_map, EdgeMapAlgorithm::dual_map_4_1_2})
        CHECK(make_edge_map_policy(algorithm, 9)->rows_read_ahead() == 0);
    CHECK(make_edge_map_policy(EdgeMapAlgorithm::inner_border, 9)->rows_read_ahead() == 1);
}

Tokens random_tokens(std::mt19937& random, int side, int count) {
    auto const draw = [&random](int below) { return static_cast<int>(random() % static_cast<unsigned>(below)); };
    Tokens tokens;
    for (int i = 0; i < count; ++i) {
        int const row = draw(side + 2) - 1;  // off the window now and then
        int const col = draw(side + 2) - 1;
        tokens.push_back(draw(3) == 0 ? edge(row, col) : object(row, col));
    }
    return tokens;
}

/// The reference's maps after the same tokens.
template <class Builder> Rows reference_picture(int side, Tokens const& tokens, bool flush_last) {
    Image<std::uint8_t> edges(side, side, 7);  // to be cleared
    Image<std::uint8_t> objects(side, side, 7);
    Builder builder(edges, objects);
    for (EdgeToken const& token : tokens) {
        builder.next_token();
        if (!edges.contains(token.row, token.col))
            continue;
        token.kind == EdgeTokenKind::Object ? builder.object(token.row, token.col) : builder.edge(token.row, token.col);
    }
    builder.end(flush_last);
    Rows rows;
    for (int row = 0; row < side; ++row) {
        rows.emplace_back();
        for (int col = 0; col < side; ++col)
            rows.back() += edges.at(row, col) != 0 ? '#' : objects.at(row, col) != 0 ? 'o' : '.';
    }
    return rows;
}

template <class Builder> void check_against_reference(EdgeMapAlgorithm algorithm) {
    unsigned const seed = 11;
    CAPTURE(static_cast<int>(algorithm), seed);
    std::mt19937 random(seed);
    for (int const side : {1, 2, 3, 9, 40}) {
        auto const policy = make_edge_map_policy(algorithm, side);
        for (int trial = 0; trial < 40; ++trial) {
            CAPTURE(side, trial);
            bool const flush_last = trial % 2 == 1;
            Tokens const tokens = random_tokens(random, side, trial == 0 ? 0 : side * side * trial / 20 + 1);
            feed(*policy, tokens, flush_last);
            CHECK(picture_of(*policy) == reference_picture<Builder>(side, tokens, flush_last));
        }
    }
}

TEST_CASE("Every policy leaves what the reference leaves after random tokens", "[edge_map]") {
    check_against_reference<reference::Threshold>(EdgeMapAlgorithm::threshold);
    check_against_reference<reference::Transition>(EdgeMapAlgorithm::transition);
    check_against_reference<reference::Bounded>(EdgeMapAlgorithm::bounded);
    check_against_reference<reference::DualMap>(EdgeMapAlgorithm::dual_map);
    check_against_reference<reference::DualMapFirstWrite>(EdgeMapAlgorithm::dual_map_4_1_2);
    check_against_reference<reference::InnerBorder>(EdgeMapAlgorithm::inner_border);
}

TEST_CASE("Two maps, finished, hold what one map of two bits holds", "[edge_map]") {
    unsigned const seed = 12;
    CAPTURE(seed);
    std::mt19937 random(seed);
    for (int trial = 0; trial < 50; ++trial) {
        CAPTURE(trial);
        Tokens const tokens = random_tokens(random, 12, 1 + trial * 5);
        auto const bounded = make_edge_map_policy(EdgeMapAlgorithm::bounded, 12);
        feed(*bounded, tokens);
        for (EdgeMapAlgorithm const algorithm : {EdgeMapAlgorithm::dual_map, EdgeMapAlgorithm::dual_map_4_1_2}) {
            auto const dual = make_edge_map_policy(algorithm, 12);
            feed(*dual, tokens, true);
            CHECK(picture_of(*dual) == picture_of(*bounded));
        }
    }
}

}  // namespace faster::datapath::edge_map_policy_test
