#include "support/twin_function.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <utility>

#include "faster/data/fixed_point.hpp"
#include "faster/data/image.hpp"
#include "faster/dataflow_names.hpp"

namespace faster::testing {
namespace {

__extension__ using WideInt = __int128;

/// A point in vertex_xy codes.
struct Point {
    std::int64_t x = 0;
    std::int64_t y = 0;
};

/// Eq. 2.6, exact; its unit is the square of the vertex_xy unit.
std::int64_t edge_value(Point const& a, Point const& b, Point const& p) {
    return (p.x - a.x) * (b.y - a.y) - (b.x - a.x) * (p.y - a.y);
}

/// floor(value / 2^bits); a negative number of bits multiplies. Values here are never negative.
WideInt scaled_down(WideInt value, int bits) {
    return bits >= 0 ? value / (WideInt{1} << bits) : value * (WideInt{1} << -bits);
}

struct Fragment {
    TwinPixel pixel;
    std::int64_t depth_code = 0;  ///< in fragment_depth codes
};

/// Rasterizer (A.1): one object per sample, draws triangle after triangle.
class Scanner {
  public:
    Scanner(Stimulus const& stimulus, SampleInput const& sample, AcceleratorConfig const& config)
        : stimulus_(stimulus),
          edge_map_(config.edge_map),
          looks_for_edges_(config.flow == Flow::faster),
          sends_objects_only_(config.rasterizer.edge_tokens == EdgeTokens::object),
          scan_(config.rasterizer.scan),
          lanes_(config.rasterizer.lanes),
          pixel_(std::int64_t{1} << stimulus.fraction.vertex_xy),
          row_offset_(sample.centre_row - stimulus.window / 2),
          col_offset_(sample.centre_col - stimulus.window / 2) {}

    TwinTriangle draw(TriangleCode const& triangle) {
        TwinTriangle result;
        Point v[3];
        for (int i = 0; i < 3; ++i) {
            v[i] = Point{triangle.vertex[i].x, triangle.vertex[i].y};
        }
        int const col_min = pixel_of(std::min({v[0].x, v[1].x, v[2].x}));
        int const col_max = pixel_of(std::max({v[0].x, v[1].x, v[2].x}));
        int const row_min = pixel_of(std::min({v[0].y, v[1].y, v[2].y}));
        int const row_max = pixel_of(std::max({v[0].y, v[1].y, v[2].y}));
        if (col_min < 0 || row_min < 0 || col_max >= stimulus_.width || row_max >= stimulus_.height) {
            return result;
        }
        result.area_code = edge_value(v[0], v[1], v[2]);
        result.is_drawn = result.area_code > 0;
        if (!result.is_drawn) {
            return result;
        }

        int start = 0;
        for (int i = 1; i < 3; ++i) {
            if (v[i].y < v[start].y) {
                start = i;
            }
        }
        int r = pixel_of(v[start].y);
        int c = pixel_of(v[start].x);
        int const left_wall = col_min;
        int const right_wall = col_max + 1;
        int const bottom = row_max;
        int direction = c == col_min ? 1 : -1;
        int line_start = c;
        bool prev_inside = is_inside(v, r, c);
        int prev_r = r;
        int prev_c = c;
        bool is_pending = false;
        TwinPixel pending;

        for (bool is_done = false; !is_done;) {
            TwinScanIteration iteration;
            if (is_pending) {
                send_edge_token(pending, false, iteration);
                is_pending = false;
                result.scan.push_back(iteration);
                continue;
            }
            bool const inside = is_inside(v, r, c);
            if (inside) {
                fragments_.push_back(Fragment{relative(r, c), depth_at(triangle, v, result.area_code, r, c)});
                iteration.sends_fragment = true;
                iteration.covered = 1;
            }
            if (!looks_for_edges_) {
                // fragments only
            } else if (sends_objects_only_) {
                if (inside) {
                    send_edge_token(relative(r, c), true, iteration);
                }
            } else if (edge_map_.algorithm == EdgeMapAlgorithm::threshold) {
                if (is_near_edge(v, r, c)) {
                    send_edge_token(relative(r, c), false, iteration);
                }
            } else if (inside && !prev_inside) {
                send_edge_token(relative(r, c), true, iteration);
                pending = relative(prev_r, prev_c);
                is_pending = true;
            } else if (!inside && prev_inside) {
                send_edge_token(relative(r, c), false, iteration);
            } else if (inside && prev_inside) {
                send_edge_token(relative(r, c), true, iteration);
            }
            prev_r = r;
            prev_c = c;
            prev_inside = inside;
            iteration.row = r;
            iteration.group = group_of(c);
            bool const ends_group = group_of(c + direction) != iteration.group;
            bool const at_wall = (c == left_wall || c == right_wall) && c != line_start;
            if (at_wall || (ends_group && may_turn(v, r, c, direction, bottom))) {
                if (r == bottom) {
                    is_done = true;
                } else {
                    ++r;
                    direction = -direction;
                    line_start = c;
                }
            } else {
                c += direction;
            }
            add_visit(iteration, result.scan);
        }
        result.fragments = static_cast<std::uint64_t>(
            std::count_if(result.scan.begin(), result.scan.end(),
                          [](TwinScanIteration const& visit) { return visit.sends_fragment; }));
        if (scan_ == ScanPolicy::spans) {
            result.scan = without_silence(result.scan);
        }
        return result;
    }

    std::vector<Fragment> const& fragments() const { return fragments_; }
    std::vector<TwinEdgeToken> const& edge_tokens() const { return edge_tokens_; }

  private:
    /// floor(code / 2^xy): codes may be negative.
    int pixel_of(std::int64_t code) const {
        std::int64_t quotient = code / pixel_;
        if (code % pixel_ < 0) {
            --quotient;
        }
        return static_cast<int>(quotient);
    }

    /// Pixels of the window's columns 0 to lanes - 1 are group 0; to the left of the window groups go on.
    int group_of(int c) const { return static_cast<int>(std::floor(static_cast<double>(c - col_offset_) / lanes_)); }

    /// Lanes of a group are tested in one iteration, which sends a token if one of them has something to send.
    static void add_visit(TwinScanIteration const& visit, std::vector<TwinScanIteration>& scan) {
        bool const is_same_group = !scan.empty() && scan.back().row == visit.row && scan.back().group == visit.group;
        if (!is_same_group) {
            scan.push_back(visit);
            return;
        }
        scan.back().sends_fragment = scan.back().sends_fragment || visit.sends_fragment;
        scan.back().sends_edge_token = scan.back().sends_edge_token || visit.sends_edge_token;
        scan.back().covered += visit.covered;
    }

    TwinPixel relative(int r, int c) const { return TwinPixel{r - row_offset_, c - col_offset_}; }

    void send_edge_token(TwinPixel const& pixel, bool is_object, TwinScanIteration& iteration) {
        edge_tokens_.push_back(TwinEdgeToken{pixel, is_object});
        iteration.sends_edge_token = true;
    }

    bool is_inside(Point const (&v)[3], int r, int c) const {
        Point const p{c * pixel_, r * pixel_};
        return edge_value(v[1], v[2], p) >= 0 && edge_value(v[2], v[0], p) >= 0 && edge_value(v[0], v[1], p) >= 0;
    }

    /// Early exit: neither this row nor, unless it is the last, the next can be covered from here on in the direction.
    bool may_turn(Point const (&v)[3], int r, int c, int direction, int bottom) const {
        return scan_ == ScanPolicy::early_exit && stays_outside(v, r, c, direction) &&
               (r == bottom || stays_outside(v, r + 1, c, direction));
    }

    /// An edge value is below zero, and one pixel on in the direction it is no larger.
    bool stays_outside(Point const (&v)[3], int r, int c, int direction) const {
        Point const here{c * pixel_, r * pixel_};
        Point const there{(c + direction) * pixel_, r * pixel_};
        for (int i = 0; i < 3; ++i) {
            std::int64_t const value = edge_value(v[i], v[(i + 1) % 3], here);
            if (value < 0 && edge_value(v[i], v[(i + 1) % 3], there) <= value) {
                return true;
            }
        }
        return false;
    }

    /// Spans: of the zigzag's iterations those that send something, and one of a row in which no visit does.
    static std::vector<TwinScanIteration> without_silence(std::vector<TwinScanIteration> const& zigzag) {
        auto const is_silent = [](TwinScanIteration const& i) { return !i.sends_fragment && !i.sends_edge_token; };
        std::vector<TwinScanIteration> spans;
        for (std::size_t i = 0; i < zigzag.size(); ++i) {
            bool is_only = is_silent(zigzag[i]) && (i == 0 || zigzag[i - 1].row != zigzag[i].row);
            for (std::size_t k = i; is_only && k < zigzag.size() && zigzag[k].row == zigzag[i].row; ++k) {
                is_only = is_silent(zigzag[k]);
            }
            if (is_only || !is_silent(zigzag[i])) {
                spans.push_back(zigzag[i]);
            }
        }
        return spans;
    }

    /// Thesis 5.1: in the triangle or at most the thresholds beyond its edges, but not further inside than they all.
    bool is_near_edge(Point const (&v)[3], int r, int c) const {
        Point const p{c * pixel_, r * pixel_};
        bool is_far_inside = true;
        for (int i = 0; i < 3; ++i) {
            double const pixels = static_cast<double>(edge_value(v[(i + 1) % 3], v[(i + 2) % 3], p)) /
                                  static_cast<double>(pixel_ * pixel_);
            double const threshold = edge_map_.thresholds[static_cast<std::size_t>(i)];
            if (pixels < -threshold) {
                return false;
            }
            is_far_inside = is_far_inside && pixels > threshold;
        }
        return !is_far_inside;
    }

    std::int64_t depth_at(TriangleCode const& triangle, Point const (&v)[3], std::int64_t area_code, int r,
                          int c) const {
        FractionBits const& bits = stimulus_.fraction;
        Point const p{c * pixel_, r * pixel_};
        WideInt const z_sum = WideInt{edge_value(v[1], v[2], p)} * triangle.vertex[0].z +
                              WideInt{edge_value(v[2], v[0], p)} * triangle.vertex[1].z +
                              WideInt{edge_value(v[0], v[1], p)} * triangle.vertex[2].z;
        WideInt const reciprocal = (WideInt{1} << (bits.area_reciprocal + 2 * bits.vertex_xy)) / area_code;
        int const shift = 2 * bits.vertex_xy + bits.vertex_z + bits.area_reciprocal - bits.fragment_depth;
        return static_cast<std::int64_t>(scaled_down(z_sum * reciprocal, shift));
    }

    Stimulus const& stimulus_;
    EdgeMapConfig const& edge_map_;
    bool const looks_for_edges_;
    bool const sends_objects_only_;
    ScanPolicy const scan_;
    int const lanes_;
    std::int64_t const pixel_;  ///< code of one pixel
    int const row_offset_;
    int const col_offset_;
    std::vector<Fragment> fragments_;
    std::vector<TwinEdgeToken> edge_tokens_;
};

/// Takes down iterations of the token loop, of a window with so many rows.
class TokenLog {
  public:
    TokenLog(TwinSampleFunction& function, int window) : function_(function), window_(window) {}

    void begin(bool reads) {
        function_.token_iteration_reads.push_back(reads);
        function_.token_touches.emplace_back();
    }
    void read(BramId bram, int row, int col) { touch({bram, {row, col}, false}); }
    void write(BramId bram, int row, int col) { touch({bram, {row, col}, true}); }

  private:
    void touch(TwinTouch const& touch) {
        if (touch.pixel.row >= 0 && touch.pixel.row < window_) {
            function_.token_touches.back().push_back(touch);
        }
    }

    TwinSampleFunction& function_;
    int window_;
};

/// EdgeMapBuilder (A.2), written with the look-ahead of the printed loop.
Image<std::uint8_t> build_edge_map(std::vector<TwinEdgeToken> const& tokens, int window, bool flush_last,
                                   TokenLog log) {
    Image<std::uint8_t> edge(window, window, 0);
    Image<std::uint8_t> object(window, window, 0);
    bool is_second_due = false;
    bool is_edge_below = false;
    bool is_edge_above = false;
    TwinPixel due;
    auto const run_second = [&] {
        log.begin(false);
        log.write(BramId::object_map, due.row, due.col);
        object.at(due.row, due.col) = 1;
        if (is_edge_below) {
            edge.at(due.row + 1, due.col) = 1;
        }
        if (is_edge_above) {
            edge.at(due.row - 1, due.col) = 1;
        }
        is_second_due = false;
    };

    std::size_t next = 0;  // tokens[next] has been read; next == size: that was the end token
    while (next != tokens.size()) {
        if (is_second_due) {
            run_second();
            continue;
        }
        TwinPixel const p = tokens[next].pixel;
        log.begin(true);
        if (edge.contains(p.row, p.col)) {
            for (int const row : tokens[next].is_object ? std::vector{p.row + 1, p.row - 1} : std::vector{p.row}) {
                log.read(BramId::object_map, row, p.col);
            }
            if (tokens[next].is_object) {
                edge.at(p.row, p.col) = 0;
                is_edge_below = p.row != window - 1 && object.at(p.row + 1, p.col) == 0;
                is_edge_above = p.row != 0 && object.at(p.row - 1, p.col) == 0;
                is_second_due = true;
                due = p;
            } else if (object.at(p.row, p.col) == 0) {
                edge.at(p.row, p.col) = 1;
            }
        }
        ++next;
    }
    if (is_second_due && flush_last) {
        run_second();
    }
    return edge;
}

/// The designs of thesis 5.1 to 5.3 as printed: one map of 0 unknown, 1 edge, 2 no edge.
Image<std::uint8_t> build_single_map(std::vector<TwinEdgeToken> const& tokens, int window, EdgeMapAlgorithm algorithm,
                                     TokenLog log) {
    Image<std::uint8_t> map(window, window, 0);
    auto const set_edge = [&](int row, int col) {
        log.read(BramId::edge_map, row, col);
        if (map.contains(row, col) && map.at(row, col) != 2) {
            log.write(BramId::edge_map, row, col);
            map.at(row, col) = 1;
        }
    };
    for (TwinEdgeToken const& token : tokens) {
        auto const [row, col] = token.pixel;
        log.begin(true);
        if (!map.contains(row, col)) {
            continue;
        }
        if (algorithm == EdgeMapAlgorithm::threshold || token.is_object) {
            log.write(BramId::edge_map, row, col);
        }
        if (algorithm == EdgeMapAlgorithm::threshold) {
            map.at(row, col) = map.at(row, col) == 0 ? 1 : 2;
        } else if (!token.is_object) {
            set_edge(row, col);
        } else {
            map.at(row, col) = 2;
            if (algorithm == EdgeMapAlgorithm::bounded) {
                set_edge(row + 1, col);
                set_edge(row - 1, col);
            }
        }
    }
    for (std::uint8_t& pixel : map.pixels()) {
        pixel = pixel == 1 ? 1 : 0;
    }
    return map;
}

/// Thesis 4.1.2: the object bit at once, the edges above and below in an iteration of their own if there are any.
Image<std::uint8_t> build_first_write(std::vector<TwinEdgeToken> const& tokens, int window, bool flush_last,
                                      TokenLog log) {
    Image<std::uint8_t> edge(window, window, 0);
    Image<std::uint8_t> object(window, window, 0);
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        auto const [row, col] = tokens[i].pixel;
        log.begin(true);
        if (!edge.contains(row, col)) {
            continue;
        }
        log.read(BramId::object_map, tokens[i].is_object ? row + 1 : row, col);
        if (!tokens[i].is_object) {
            edge.at(row, col) = object.at(row, col) != 0 ? edge.at(row, col) : std::uint8_t{1};
            continue;
        }
        log.read(BramId::object_map, row - 1, col);
        log.write(BramId::object_map, row, col);
        object.at(row, col) = 1;
        edge.at(row, col) = 0;
        bool const edge_down = row + 1 < window && object.at(row + 1, col) == 0;
        bool const edge_up = row > 0 && object.at(row - 1, col) == 0;
        if ((!edge_down && !edge_up) || (i + 1 == tokens.size() && !flush_last)) {
            continue;
        }
        log.begin(false);
        if (edge_down) {
            edge.at(row + 1, col) = 1;
        }
        if (edge_up) {
            edge.at(row - 1, col) = 1;
        }
    }
    return edge;
}

/// Thesis 7.2: covered pixels of which a neighbour in the window is not covered.
Image<std::uint8_t> build_inner_border(std::vector<TwinEdgeToken> const& tokens, int window) {
    Image<std::uint8_t> object(window, window, 0);
    for (TwinEdgeToken const& token : tokens) {
        if (token.is_object && object.contains(token.pixel.row, token.pixel.col)) {
            object.at(token.pixel.row, token.pixel.col) = 1;
        }
    }
    Image<std::uint8_t> edge(window, window, 0);
    for (int row = 0; row < window; ++row) {
        for (int col = 0; col < window; ++col) {
            for (auto const& [down, right] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
                bool const is_bare =
                    object.contains(row + down, col + right) && object.at(row + down, col + right) == 0;
                if (object.at(row, col) != 0 && is_bare) {
                    edge.at(row, col) = 1;
                }
            }
        }
    }
    return edge;
}

/// By the configured algorithm; also sets what its loops take.
Image<std::uint8_t> build(std::vector<TwinEdgeToken> const& tokens, int window, EdgeMapConfig const& config,
                          TwinSampleFunction& result) {
    switch (config.algorithm) {
        case EdgeMapAlgorithm::dual_map:
            return build_edge_map(tokens, window, config.flush_last, {result, window});
        case EdgeMapAlgorithm::dual_map_4_1_2:
            return build_first_write(tokens, window, config.flush_last, {result, window});
        case EdgeMapAlgorithm::inner_border:
            result.token_iteration_reads.assign(tokens.size(), true);  // reads neither map
            result.output_reads_ahead = true;
            return build_inner_border(tokens, window);
        case EdgeMapAlgorithm::threshold:
        case EdgeMapAlgorithm::transition:
        case EdgeMapAlgorithm::bounded:
            break;
    }
    return build_single_map(tokens, window, config.algorithm, {result, window});
}

/// Eq. 2.2 without square roots and quotients: floor(65536 a / (n b)) > t, with a and b rounded down to integers.
bool is_curved(Image<std::uint16_t> const& buffer, int row, int col, EdgeExtractionConfig const& config) {
    int const reach = config.neighbourhood / 2, middle = buffer.width() / 2;
    auto const slope = [&](int position) {
        double const exact = std::ldexp((position - middle) / config.focal_length_px, 15);
        return static_cast<WideInt>(std::floor(std::min(131071.0, std::max(-131072.0, exact))));
    };
    auto const square_of = [](WideInt component) {
        WideInt kept = component / 2048;
        kept -= component % 2048 < 0 ? 1 : 0;
        return kept * kept;
    };
    WideInt const z = buffer.at(row, col);
    WideInt x_sum = 0, y_sum = 0, z_sum = 0, neighbours = -1;
    for (int r = std::max(0, row - reach); r <= std::min(buffer.height() - 1, row + reach); ++r) {
        for (int c = std::max(0, col - reach); c <= std::min(buffer.width() - 1, col + reach); ++c) {
            WideInt const other = buffer.at(r, c);
            x_sum += other * slope(c) - z * slope(col);
            y_sum += other * slope(r) - z * slope(row);
            z_sum += (other - z) * 32768;
            ++neighbours;
        }
    }
    WideInt const a_square = square_of(x_sum) + square_of(y_sum) + square_of(z_sum);
    WideInt const b_square = square_of(z * slope(col)) + square_of(z * slope(row)) + square_of(z * 32768);
    auto const root_of = [](WideInt square) {
        auto root = static_cast<WideInt>(std::sqrt(static_cast<long double>(square)));
        while (root * root > square) {
            --root;
        }
        return root;
    };
    WideInt const threshold = static_cast<WideInt>(config.threshold * 65536);
    WideInt const divisor = neighbours * root_of(b_square);
    return divisor > 0 && 65536 * root_of(a_square) >= (threshold + 1) * divisor;
}

Image<std::uint8_t> extracted_edges(Image<std::uint16_t> const& buffer, int near, EdgeExtractionConfig const& config) {
    Image<std::uint8_t> edges(buffer.height(), buffer.width());
    for (int row = 0; row < buffer.height(); ++row) {
        for (int col = 0; col < buffer.width(); ++col) {
            edges.at(row, col) = buffer.at(row, col) < near && is_curved(buffer, row, col, config) ? 1 : 0;
        }
    }
    return edges;
}

/// InlierUnit (A.3). Without an edge map, edges are extracted.
SampleCounters score(Stimulus const& stimulus, SampleInput const& sample, std::vector<Fragment> const& fragments,
                     Image<std::uint8_t> edge_map, AcceleratorConfig const& config, TwinTouches& touches) {
    bool const extracts = config.flow == Flow::fpga_grip;
    bool const edge_has_depth = extracts || config.edge_map.algorithm == EdgeMapAlgorithm::inner_border;
    int const window = stimulus.window;
    int const buffer_bits = stimulus.fraction.depth_buffer;
    int const fragment_bits = stimulus.fraction.fragment_depth;
    SampleCounters counters;

    Image<std::uint16_t> buffer(window, window, far_depth_code);
    for (Fragment const& fragment : fragments) {
        touches.emplace_back();
        if (!buffer.contains(fragment.pixel.row, fragment.pixel.col)) {
            continue;
        }
        touches.back().push_back({BramId::depth_buffer, fragment.pixel, false});
        std::uint16_t& stored = buffer.at(fragment.pixel.row, fragment.pixel.col);
        WideInt const two = WideInt{2} << fragment_bits;
        // depth / 2^fragment_bits <= stored / 2^buffer_bits, multiplied out
        bool const is_nearer = (WideInt{fragment.depth_code} << buffer_bits) <= (WideInt{stored} << fragment_bits);
        if (fragment.depth_code <= two && is_nearer) {
            stored = static_cast<std::uint16_t>(scaled_down(fragment.depth_code, fragment_bits - buffer_bits));
            touches.back().push_back({BramId::depth_buffer, fragment.pixel, true});
            ++counters.valid_raster;
        }
    }

    int const two = 2 << buffer_bits;
    if (extracts) {
        edge_map = extracted_edges(buffer, two, config.edge_extraction);
    }
    int const three = 3 << buffer_bits;
    for (int r = 1; r < window - 1; ++r) {
        for (int c = 1; c < window - 1; ++c) {
            int const image_row = sample.centre_row - window / 2 + r;
            int const image_col = sample.centre_col - window / 2 + c;
            bool const is_seen =
                image_row >= 0 && image_row < stimulus.height && image_col >= 0 && image_col < stimulus.width;
            int const observed = is_seen ? stimulus.observed_depth.at(image_row, image_col) : 0;
            bool const observed_edge = is_seen && stimulus.observed_edges.at(image_row, image_col) != 0;
            bool const edge = edge_map.at(r, c) != 0;
            int z = 0;
            if (edge) {
                ++counters.valid_edge;
            }
            if (edge && !edge_has_depth) {
                for (int const neighbour :
                     {buffer.at(r + 1, c), buffer.at(r - 1, c), buffer.at(r, c + 1), buffer.at(r, c - 1)}) {
                    if (neighbour < two) {
                        z = neighbour;
                        break;
                    }
                }
            } else {
                z = buffer.at(r, c);
            }
            // |z - observed| / 2^buffer_bits <= 2 / 256, multiplied out
            if (z < two && std::abs(z - observed) * 256 <= two) {
                ++counters.inlier;
                if (edge && observed_edge) {
                    ++counters.edge_inlier;
                }
            }
            if (observed <= three) {
                ++counters.valid_depth;
            }
        }
    }
    return counters;
}

/// Tokens of the edge map builder where each holds a group.
std::size_t groups_with_edges(std::vector<TwinTriangle> const& triangles) {
    std::size_t groups = 0;
    for (TwinTriangle const& triangle : triangles) {
        for (TwinScanIteration const& iteration : triangle.scan) {
            groups += iteration.sends_edge_token ? 1 : 0;
        }
    }
    return groups;
}

/// Of all pixels that a token holds together.
TwinTouches joined_by_token(TwinTouches const& of_pixels, std::vector<TwinTriangle> const& triangles) {
    TwinTouches of_tokens;
    auto pixel = of_pixels.begin();
    for (TwinTriangle const& triangle : triangles) {
        for (TwinScanIteration const& iteration : triangle.scan) {
            if (!iteration.sends_fragment) {
                continue;
            }
            of_tokens.emplace_back();
            for (int i = 0; i < iteration.covered; ++i, ++pixel) {
                of_tokens.back().insert(of_tokens.back().end(), pixel->begin(), pixel->end());
            }
        }
    }
    return of_tokens;
}

TwinRegion bounds_of(Image<std::uint8_t> const& marks) {
    TwinRegion region{marks.pixels().size(), 0, marks.pixels().size(), 0};
    for (int row = 0; row < marks.height(); ++row) {
        for (int col = 0; col < marks.width(); ++col) {
            if (marks.at(row, col) != 0) {
                region.first_row = std::min(region.first_row, static_cast<std::size_t>(row));
                region.end_row = std::max(region.end_row, static_cast<std::size_t>(row) + 1);
                region.first_col = std::min(region.first_col, static_cast<std::size_t>(col));
                region.end_col = std::max(region.end_col, static_cast<std::size_t>(col) + 1);
            }
        }
    }
    return region.end_row == 0 ? TwinRegion{} : region;
}

/// Marks the pixels of the window that fragments and tokens can change, and bounds them. Tokens that lie elsewhere
/// would be missed, so they are an error here.
TwinRegion touched_region(std::vector<Fragment> const& fragments, std::vector<TwinEdgeToken> const& tokens, int window,
                          AcceleratorConfig const& config) {
    bool const is_threshold = config.edge_map.algorithm == EdgeMapAlgorithm::threshold;
    bool const is_on_object =
        config.flow == Flow::fpga_grip || config.edge_map.algorithm == EdgeMapAlgorithm::inner_border;
    int const reach = is_threshold || is_on_object ? 0 : 1;
    Image<std::uint8_t> marks(window, window, 0);
    auto const mark = [&](TwinPixel const& pixel) {
        for (int row = pixel.row - reach; row <= pixel.row + reach; ++row) {
            for (int col = pixel.col - reach; col <= pixel.col + reach; ++col) {
                if (marks.contains(row, col)) {
                    marks.at(row, col) = 1;
                }
            }
        }
    };
    for (Fragment const& fragment : fragments) {
        mark(fragment.pixel);
    }
    for (TwinEdgeToken const& token : tokens) {
        if (is_threshold) {
            mark(token.pixel);
        } else if (!is_on_object && marks.contains(token.pixel.row, token.pixel.col) &&
                   marks.at(token.pixel.row, token.pixel.col) == 0) {
            throw std::logic_error("an edge token far from all fragments");
        }
    }
    return bounds_of(marks);
}

}  // namespace

TwinSampleFunction evaluate_sample(Stimulus const& stimulus, std::size_t sample, AcceleratorConfig const& config) {
    SampleInput const& input = stimulus.samples.at(sample);
    TwinSampleFunction result;
    Scanner scanner(stimulus, input, config);
    for (std::uint32_t i = 0; i < input.triangle_count; ++i) {
        result.triangles.push_back(scanner.draw(stimulus.triangles.at(input.first_triangle + i)));
    }
    Image<std::uint8_t> edges = build(scanner.edge_tokens(), stimulus.window, config.edge_map, result);
    if (config.rasterizer.lanes > 1) {
        result.token_iteration_reads.assign(groups_with_edges(result.triangles), true);
        result.token_touches.clear();
    }
    auto const side = static_cast<std::size_t>(stimulus.window);
    result.region = config.inlier_unit.sweep_region == SweepRegion::touched
                        ? touched_region(scanner.fragments(), scanner.edge_tokens(), stimulus.window, config)
                        : TwinRegion{0, side, 0, side};
    TwinTouches of_pixels;
    result.counters = score(stimulus, input, scanner.fragments(), std::move(edges), config, of_pixels);
    result.fragment_touches = joined_by_token(of_pixels, result.triangles);
    return result;
}

}  // namespace faster::testing
