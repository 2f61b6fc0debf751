#include "support/random_stimulus.hpp"

#include <algorithm>
#include <cstdlib>
#include <initializer_list>
#include <random>
#include <utility>

#include "faster/dataflow_names.hpp"
#include "support/plain_config.hpp"

namespace faster::testing {
namespace {

/// Whole numbers from a seeded engine. The standard distributions are not the same in every library; this is.
class Dice {
  public:
    explicit Dice(std::uint64_t seed) : engine_(seed) {}

    int between(int low, int high) {
        std::uint64_t const span = static_cast<std::uint64_t>(std::int64_t{high} - low) + 1;
        return low + static_cast<int>(engine_() % span);
    }
    int in(IntRange const& range) { return between(range.low, range.high); }
    bool one_in(int n) { return between(1, n) == 1; }

  private:
    std::mt19937_64 engine_;
};

/// How far out a triangle may reach that is to be out of the image.
constexpr int pixels_beyond_image = 20;

/// Corners in vertex_xy codes.
struct ImagePoint {
    int x = 0;
    int y = 0;
};

struct Corners {
    ImagePoint at[3];
};

std::int64_t area_of(Corners const& t) {
    return std::int64_t{t.at[2].x - t.at[0].x} * (t.at[1].y - t.at[0].y) -
           std::int64_t{t.at[1].x - t.at[0].x} * (t.at[2].y - t.at[0].y);
}

/// Draws the triangles of one stimulus.
class TriangleDice {
  public:
    TriangleDice(Dice& dice, Stimulus const& stimulus, double base_depth)
        : dice_(dice),
          pixel_(1 << stimulus.fraction.vertex_xy),
          max_x_(stimulus.width * pixel_ - 1),
          max_y_(stimulus.height * pixel_ - 1),
          window_(stimulus.window),
          metre_(1 << stimulus.fraction.vertex_z),
          base_depth_(base_depth) {}

    TriangleCode draw(TriangleKind kind, SampleInput const& sample) {
        if (kind == TriangleKind::Rejected) {
            VertexCode const vertex{rejected_vertex_code, rejected_vertex_code, 0};
            return TriangleCode{{vertex, vertex, vertex}};
        }
        Corners corners = corners_of(kind, sample);
        bool const is_front = area_of(corners) > 0;
        if (is_front == (kind == TriangleKind::BackFacing)) {
            std::swap(corners.at[1], corners.at[2]);
        }
        TriangleCode triangle;
        int const depth = depth_code();
        for (int i = 0; i < 3; ++i) {
            triangle.vertex[i].x = static_cast<std::int16_t>(corners.at[i].x);
            triangle.vertex[i].y = static_cast<std::int16_t>(corners.at[i].y);
            int const slope = dice_.between(-metre_ / 32, metre_ / 32);
            triangle.vertex[i].z = static_cast<std::uint16_t>(std::clamp(depth + slope, 0, 65535));
        }
        return triangle;
    }

  private:
    Corners corners_of(TriangleKind kind, SampleInput const& sample) {
        ImagePoint const centre = near_centre(sample);
        switch (kind) {
            case TriangleKind::Tiny:
                return around(centre, 2 * pixel_);
            case TriangleKind::Small:
                return around(centre, 8 * pixel_);
            case TriangleKind::Huge:
                return huge();
            case TriangleKind::Sliver:
                return sliver(centre);
            case TriangleKind::Degenerate:
                return degenerate(centre);
            case TriangleKind::Border:
                return border();
            case TriangleKind::OffWindow:
                return around(anywhere(), 12 * pixel_);
            case TriangleKind::OutOfImage:
                return out_of_image();
            case TriangleKind::WholePixels:
                return whole_pixels(centre);
            case TriangleKind::BackFacing:
            case TriangleKind::Rejected:
                break;
        }
        return around(centre, 10 * pixel_);
    }

    ImagePoint clipped(int x, int y) const { return ImagePoint{std::clamp(x, 0, max_x_), std::clamp(y, 0, max_y_)}; }
    ImagePoint anywhere() { return ImagePoint{dice_.between(0, max_x_), dice_.between(0, max_y_)}; }

    ImagePoint near_centre(SampleInput const& sample) {
        int const reach = window_ / 2 + 2;
        return clipped((sample.centre_col + dice_.between(-reach, reach)) * pixel_ + dice_.between(0, pixel_ - 1),
                       (sample.centre_row + dice_.between(-reach, reach)) * pixel_ + dice_.between(0, pixel_ - 1));
    }

    Corners around(ImagePoint const& centre, int reach) {
        Corners t;
        for (ImagePoint& corner : t.at) {
            corner = clipped(centre.x + dice_.between(-reach, reach), centre.y + dice_.between(-reach, reach));
        }
        return t;
    }

    Corners huge() {
        Corners t{{ImagePoint{dice_.between(0, max_x_ / 4), dice_.between(0, max_y_)},
                   ImagePoint{dice_.between(3 * (max_x_ / 4), max_x_), dice_.between(0, max_y_ / 4)},
                   ImagePoint{dice_.between(0, max_x_), dice_.between(3 * (max_y_ / 4), max_y_)}}};
        std::rotate(&t.at[0], &t.at[dice_.between(0, 2)], &t.at[0] + 3);
        return t;
    }

    Corners sliver(ImagePoint const& from) {
        ImagePoint const to = anywhere();
        int const width = 2 * pixel_;
        return Corners{{from, to, clipped(to.x + dice_.between(-width, width), to.y + dice_.between(-width, width))}};
    }

    Corners degenerate(ImagePoint const& centre) {
        if (dice_.one_in(3)) {
            return Corners{{centre, centre, centre}};
        }
        if (dice_.one_in(2)) {
            return Corners{{centre, centre, anywhere()}};
        }
        int const dx = dice_.between(-3, 3);
        int const dy = dice_.between(-3, 3);
        ImagePoint const from{std::clamp(centre.x, 6, max_x_ - 6), std::clamp(centre.y, 6, max_y_ - 6)};
        return Corners{{from, ImagePoint{from.x + dx, from.y + dy}, ImagePoint{from.x - 2 * dx, from.y - 2 * dy}}};
    }

    Corners border() {
        Corners t = around(anywhere(), 10 * pixel_);
        ImagePoint& corner = t.at[dice_.between(0, 2)];
        switch (dice_.between(0, 3)) {
            case 0:
                corner.x = 0;
                break;
            case 1:
                corner.y = 0;
                break;
            case 2:
                corner.x = max_x_;
                break;
            default:
                corner.y = max_y_;
                break;
        }
        return t;
    }

    Corners out_of_image() {
        Corners t = around(anywhere(), 10 * pixel_);
        ImagePoint& corner = t.at[dice_.between(0, 2)];
        int const beyond = dice_.one_in(2) ? 1 : dice_.between(1, pixels_beyond_image * pixel_);
        switch (dice_.between(0, 3)) {
            case 0:
                corner.x = -beyond;
                break;
            case 1:
                corner.y = -beyond;
                break;
            case 2:
                corner.x = max_x_ + beyond;
                break;
            default:
                corner.y = max_y_ + beyond;
                break;
        }
        return t;
    }

    Corners whole_pixels(ImagePoint const& centre) {
        Corners t = around(centre, 10 * pixel_);
        for (ImagePoint& corner : t.at) {
            corner.x -= corner.x % pixel_;
            corner.y -= corner.y % pixel_;
        }
        return t;
    }

    int depth_code() {
        int const choice = dice_.between(1, 12);
        if (choice == 1) {
            return 0;
        }
        if (choice == 2) {
            return 65535;
        }
        if (choice == 3) {  // around the 2 m of the depth test
            return 2 * metre_ + dice_.between(-metre_ / 16, metre_ / 16);
        }
        return static_cast<int>(base_depth_ * metre_) + dice_.between(-metre_ / 64, metre_ / 64);
    }

    Dice& dice_;
    int const pixel_;
    int const max_x_;
    int const max_y_;
    int const window_;
    int const metre_;
    double const base_depth_;
};

/// `reach_px` is the largest coordinate to be expressed in s16.
FractionBits random_fraction_bits(Dice& dice, int reach_px) {
    int most_xy_bits = 0;
    while (most_xy_bits < 7 && (reach_px << (most_xy_bits + 1)) <= 32767) {
        ++most_xy_bits;
    }
    FractionBits bits;
    bits.vertex_xy = dice.between(0, most_xy_bits);
    bits.vertex_z = dice.between(8, 15);
    bits.area_reciprocal = dice.between(16, 32);
    bits.fragment_depth = dice.between(7, 20);
    bits.depth_buffer = dice.between(5, 10);
    return bits;
}

void fill_observation(Dice& dice, double base_depth, Stimulus& stimulus) {
    stimulus.observed_depth = Image<std::uint16_t>(stimulus.height, stimulus.width);
    stimulus.observed_edges = Image<std::uint8_t>(stimulus.height, stimulus.width);
    int const metre = 1 << stimulus.fraction.depth_buffer;
    int const near = static_cast<int>(base_depth * metre);
    for (std::uint16_t& pixel : stimulus.observed_depth.pixels()) {
        int code = near + dice.between(-metre / 32 - 2, metre / 32 + 2);
        switch (dice.between(1, 10)) {
            case 1:
                code = 0;
                break;
            case 2:
                code = far_depth_code;
                break;
            case 3:  // around the 3 m of valid_depth
                code = 3 * metre + dice.between(-1, 1);
                break;
            case 4:
                code = dice.between(0, far_depth_code);
                break;
            default:
                break;
        }
        pixel = static_cast<std::uint16_t>(std::clamp(code, 0, int{far_depth_code}));
    }
    for (std::uint8_t& pixel : stimulus.observed_edges.pixels()) {
        pixel = dice.one_in(3) ? 1 : 0;
    }
}

/// Small values often, large ones now and then: most of what goes wrong in a FIFO goes wrong near its depth.
int skewed(Dice& dice, IntRange const& range) {
    int const reach = range.high - range.low;
    return range.low + (dice.one_in(4) ? dice.between(0, reach) : dice.between(0, std::min(3, reach)));
}

Cycles skewed_cycles(Dice& dice, Cycles high) {
    return dice.one_in(2) ? 1 : static_cast<Cycles>(dice.between(1, static_cast<int>(high)));
}

void draw_extraction(Dice& dice, EdgeExtractionConfig& config) {
    config.neighbourhood = 3 + 2 * dice.between(0, dice.one_in(4) ? 6 : 2);
    config.threshold = dice.one_in(8) ? 0.0 : dice.between(1, 400) / 10000.0;
    config.focal_length_px = dice.one_in(8) ? dice.between(1, 20) : dice.between(20, 1000);
    config.neighbour_access = static_cast<NeighbourAccess>(dice.between(0, 1));
    config.square_root_latency = static_cast<Cycles>(dice.between(1, 40));
    config.divider_latency = static_cast<Cycles>(dice.between(1, 60));
}

/// A token of each of `fifos` is read together with `look_ahead` + 1 or fewer tokens of the others. A FIFO written
/// before the others must hold what is written until they follow.
void make_room(AcceleratorConfig& config, std::initializer_list<FifoId> fifos, Cycles look_ahead) {
    Cycles latest = 0;
    for (FifoId const id : fifos) {
        latest = std::max(latest, fifo_of(config, id).write_latency);
    }
    for (FifoId const id : fifos) {
        FifoConfig const fifo = fifo_of(config, id);
        config.fifo(id).depth = std::max<std::uint64_t>(fifo.depth, latest - fifo.write_latency + look_ahead + 1);
    }
}

/// Of loops with keys of their own, in a machine with one buffer of each map.
bool has_loop(Flow flow, LoopId id) {
    bool const extracts = flow == Flow::fpga_grip;
    return id == LoopId::extract ? extracts : id.module != ModuleId::edge_map_builder || !extracts;
}

void draw_scan(Dice& dice, AcceleratorConfig& config) {
    bool const has_near_edges = config.edge_map.algorithm == EdgeMapAlgorithm::threshold;  // zigzag only
    config.rasterizer.scan = static_cast<ScanPolicy>(dice.between(0, has_near_edges ? 0 : 2));
    config.rasterizer.setup_overlap = static_cast<std::uint64_t>(dice.one_in(3) ? 0 : dice.between(1, 7));
    bool const needs_objects_only = config.edge_map.algorithm == EdgeMapAlgorithm::inner_border;
    config.rasterizer.edge_tokens = static_cast<EdgeTokens>(dice.between(0, needs_objects_only ? 1 : 0));
    config.inlier_unit.fragment_loop = static_cast<FragmentLoop>(dice.between(0, 1));
}

}  // namespace

Stimulus random_stimulus(std::uint64_t seed, RandomStimulusOptions const& options) {
    Dice dice(seed);
    Stimulus stimulus;
    stimulus.width = dice.in(options.width);
    stimulus.height = dice.in(options.height);
    stimulus.window = dice.in(options.window);
    if (options.random_fraction_bits) {
        stimulus.fraction = random_fraction_bits(dice, std::max(stimulus.width, stimulus.height) + pixels_beyond_image);
    }
    double const base_depth = dice.between(30, 210) / 100.0;
    fill_observation(dice, base_depth, stimulus);

    TriangleDice triangles(dice, stimulus, base_depth);
    int const samples = dice.in(options.samples);
    for (int i = 0; i < samples; ++i) {
        SampleInput sample;
        bool const is_far_off = dice.one_in(8);
        int const margin = is_far_off ? stimulus.window : 0;
        sample.centre_row = dice.between(-margin, stimulus.height - 1 + margin);
        sample.centre_col = dice.between(-margin, stimulus.width - 1 + margin);
        if (options.share_triangles && i > 0 && dice.one_in(6)) {
            sample.first_triangle = stimulus.samples.back().first_triangle;
            sample.triangle_count = stimulus.samples.back().triangle_count;
        } else {
            int const count = dice.in(options.triangles);
            sample.first_triangle = static_cast<std::uint32_t>(stimulus.triangles.size());
            sample.triangle_count = static_cast<std::uint32_t>(count);
            for (int t = 0; t < count; ++t) {
                TriangleKind const mixed = static_cast<TriangleKind>(dice.between(0, triangle_kind_count - 1));
                stimulus.triangles.push_back(triangles.draw(options.kind.value_or(mixed), sample));
            }
        }
        stimulus.samples.push_back(sample);
    }
    return stimulus;
}

AcceleratorConfig random_config(std::uint64_t seed, RandomConfigOptions const& options) {
    Dice dice(seed);
    AcceleratorConfig config;
    config.cores = static_cast<std::uint64_t>(dice.in(options.cores));
    config.edge_map.flush_last = dice.one_in(2);
    config.setup("rasterizer") = static_cast<Cycles>(dice.between(1, 16));
    for (BramId const id : bram_ids) {
        config.memory(id).ports = static_cast<std::uint64_t>(dice.between(1, static_cast<int>(options.max_ports)));
    }
    config.flow = options.flow;
    for (LoopId const id : keyed_loop_ids) {
        if (!has_loop(config.flow, id)) {
            continue;
        }
        LoopSettings& loop = config.loop(id);
        loop.ii = skewed_cycles(dice, options.max_target_ii);
        loop.recurrence_ii = skewed_cycles(dice, options.max_recurrence_ii);
        loop.depth = static_cast<Cycles>(dice.one_in(2) ? dice.between(1, 4) : dice.between(1, 24));
    }
    auto const draw_fifo = [&](FifoId id) {
        FifoSettings& fifo = config.fifo(id);
        fifo.depth = static_cast<std::uint64_t>(skewed(dice, options.fifo_depth));
        fifo.kind = static_cast<FifoKind>(dice.between(0, 2));
        fifo.write_latency = 0;
    };
    for (std::size_t i = 0; i <= index_of(FifoId::result); ++i) {
        draw_fifo(fifo_ids[i]);
    }
    auto const draw_latency = [&](FifoId fifo, LoopId loop) {
        int const last_stage = static_cast<int>(loop_of(config, loop).depth) - 1;
        config.fifo(fifo).write_latency =
            static_cast<Cycles>(dice.one_in(2) ? last_stage : dice.between(0, last_stage));
    };
    draw_latency(FifoId::vertex, LoopId::vertex);
    draw_latency(FifoId::command, LoopId::scan);
    draw_latency(FifoId::fragment_depth, LoopId::scan);
    draw_latency(FifoId::fragment_index, LoopId::scan);
    draw_latency(FifoId::edge_token, LoopId::scan);
    draw_latency(FifoId::edge_map, LoopId::output);
    draw_latency(FifoId::observed_depth, LoopId::read);
    draw_latency(FifoId::observed_edge, LoopId::read);
    config.fifo(FifoId::area_reciprocal).write_latency = static_cast<Cycles>(dice.between(0, dice.one_in(2) ? 1 : 40));
    config.edge_map.algorithm = options.algorithm;
    if (options.any_clearing) {
        int const last = options.any_partition ? 2 : 1;
        config.edge_map.clearing = static_cast<MapClearing>(dice.between(0, last));
        config.inlier_unit.clearing = static_cast<MapClearing>(dice.between(0, last));
        config.inlier_unit.neighbour_access = static_cast<NeighbourAccess>(dice.between(0, 1));
    }
    if (options.any_scan) {
        draw_scan(dice, config);
    }
    if (options.max_lanes > 1) {
        config.inlier_unit.sweep_lanes = dice.between(1, options.max_lanes);
    }
    if (options.max_scan_lanes > 1) {
        config.rasterizer.lanes = dice.between(1, options.max_scan_lanes);
        config.rasterizer.edge_tokens = EdgeTokens::object;
    }
    for (BramId const id : bram_ids) {
        if (options.any_partition) {
            config.memory(id).partition = {static_cast<PartitionType>(dice.between(0, 2)),
                                           static_cast<std::uint64_t>(dice.between(1, 4)),
                                           static_cast<std::uint64_t>(dice.between(0, 2))};
        }
    }
    for (double& threshold : config.edge_map.thresholds) {
        threshold = dice.one_in(4) ? 0.0 : dice.between(0, 120) / 8.0;
    }
    if (options.flow == Flow::fpga_grip) {
        draw_extraction(dice, config.edge_extraction);
    }
    if (options.any_region) {
        config.inlier_unit.sweep_region = static_cast<SweepRegion>(dice.between(0, 1));
        draw_fifo(FifoId::region);
        draw_fifo(FifoId::valid_depth);
    }
    if (options.any_buffers) {  // last, so that what is drawn before does not depend on it
        config.edge_map.buffers = options.flow == Flow::faster ? dice.between(1, 2) : 1;
        config.inlier_unit.buffers = dice.between(1, 2);
        for (FifoId const fifo : {FifoId::map_full, FifoId::map_free, FifoId::depth_full, FifoId::depth_free}) {
            draw_fifo(fifo);
        }
    }
    if (dice.one_in(4)) {
        config.fifo(FifoId::area_reciprocal).when_full = WhenFull::squeeze;
    }
    if (options.is_deadlock_free) {
        make_room(config, {FifoId::command, FifoId::fragment_depth, FifoId::fragment_index}, 1);
        if (config.rasterizer.setup_overlap > 0) {  // an area leaves at once, its command when it has passed the loop
            Cycles const stages = loop_of(config, LoopId::scan).depth;
            config.fifo(FifoId::area).depth = std::max<std::uint64_t>(fifo_of(config, FifoId::area).depth, stages);
        }
        make_room(config, {FifoId::observed_depth, FifoId::observed_edge}, 0);
    }
    Dice more(~seed);  // changes nothing else that is drawn
    config.fifo_rules = static_cast<FifoGeneration>(more.between(0, 2));
    config.number("area_reciprocal.interval") = static_cast<std::uint64_t>(more.one_in(2) ? 1 : more.between(2, 9));
    return config;
}

void adopt(Stimulus const& stimulus, AcceleratorConfig& config) {
    config.window = stimulus.window;
    if (stimulus.fraction.depth_buffer > 9) {
        config.inlier_unit.sweep_region = SweepRegion::window;
    }
}

}  // namespace faster::testing
