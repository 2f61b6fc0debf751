#pragma once
#include <cstdint>
#include <optional>

#include "dataflow/base/cycles.hpp"
#include "faster/config/accelerator_config.hpp"
#include "faster/data/stimulus.hpp"
#include "faster/dataflow_names.hpp"

namespace faster::testing {

/// A closed range of whole numbers; `{n, n}` fixes the number.
struct IntRange {
    int low = 0;
    int high = 0;
};

/// What a random triangle is there to provoke.
enum class TriangleKind {
    Tiny,         ///< about a pixel, often without a fragment
    Small,        ///< a few pixels, near the window's centre
    Huge,         ///< across most of the image
    Sliver,       ///< long and less than a few pixels wide
    Degenerate,   ///< area 0: collinear or coinciding vertices
    BackFacing,   ///< area < 0
    Border,       ///< touches an image border from inside
    OffWindow,    ///< inside the image, anywhere
    OutOfImage,   ///< at least one vertex beyond the image
    Rejected,     ///< what the vertex transform makes of a vertex it cannot express: x = y = -32768, z = 0
    WholePixels,  ///< corners on pixels, so that edges run through pixels
};
constexpr int triangle_kind_count = 11;

struct RandomStimulusOptions {
    IntRange width{24, 96};
    IntRange height{24, 96};
    IntRange window{8, 40};
    IntRange samples{0, 12};
    IntRange triangles{0, 20};          ///< per sample
    std::optional<TriangleKind> kind;   ///< all triangles of this kind; otherwise mixed
    bool random_fraction_bits = false;  ///< otherwise the defaults of docs/function.md#formats
    bool share_triangles = true;        ///< now and then a sample reuses the triangles of the one before
};

/// A trace (no posed mesh), valid by docs/formats.md#stimulus-trace and reproducible: equal seeds and options give
/// equal stimuli with every compiler. Depths are drawn around one distance per stimulus, so that depth tests go both
/// ways.
Stimulus random_stimulus(std::uint64_t seed, RandomStimulusOptions const& options = {});

struct RandomConfigOptions {
    IntRange cores{1, 12};
    IntRange fifo_depth{1, 64};
    Cycles max_target_ii = 4;
    Cycles max_recurrence_ii = 4;
    std::uint64_t max_ports = 3;
    Flow flow = Flow::faster;  ///< fpga_grip: draws its edge extraction, too
    EdgeMapAlgorithm algorithm = EdgeMapAlgorithm::dual_map;
    bool any_scan = false;       ///< draws how triangles are prepared and scanned, and how their fragments are taken
    bool any_clearing = false;   ///< draws how maps are cleared, and how the sweep reads
    bool any_partition = false;  ///< draws banks of block RAMs, for windows of at least 4; and clearings that use them
    int max_lanes = 1;           ///< of the sweep, at most the window
    bool any_buffers = false;    ///< draws one or two buffers of maps and of the depth buffer
    int max_scan_lanes = 1;      ///< of the scan: only with inner_border, which then gets object tokens, or fpga_grip
    bool any_region = false;     ///< draws which pixels are swept
    /// Makes the FIFOs that are written and read side by side (command, fragment_depth, fragment_index; observed_depth,
    /// observed_edge) deep enough for their write latencies; else many a configuration deadlocks, as it should.
    bool is_deadlock_free = true;
};

/// A valid configuration of every timing key, and of the edge map's thresholds. Window and fraction bits stay at their
/// defaults: with a trace they are the trace's, so a caller copies them from its stimulus.
AcceleratorConfig random_config(std::uint64_t seed, RandomConfigOptions const& options = {});

/// Gives a configuration the window of a stimulus; and sweep_region window where the fraction bits demand it.
void adopt(Stimulus const& stimulus, AcceleratorConfig& config);

}  // namespace faster::testing
