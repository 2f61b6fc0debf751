#include "tb/cosim/twin_core.hpp"

#include <Vcosimulated_core.h>
#include <Vcosimulated_core___024root.h>

namespace faster::rtl {

namespace {

void set(Vcosimulated_core& core, TwinSettings const& settings) {
    core.width = settings.width;
    core.height = settings.height;
    core.window = settings.window;
    core.vertex_xy = static_cast<CData>(settings.fraction.vertex_xy);
    core.vertex_z = static_cast<CData>(settings.fraction.vertex_z);
    core.area_reciprocal_fraction = static_cast<CData>(settings.fraction.area_reciprocal);
    core.fragment_depth_fraction = static_cast<CData>(settings.fraction.fragment_depth);
    core.depth_buffer_fraction = static_cast<CData>(settings.fraction.depth_buffer);
    core.sends_edges = settings.sends_edges;
    core.is_inner_border = settings.is_inner_border;
    core.flushes_last = settings.flushes_last;
    core.forwards_object_map = settings.forwards;
    core.forwards_depth_buffer = settings.forwards;
    core.fragment_loop_is_flattened = settings.is_flattened;
    core.edge_map_clears_on_read_out = settings.edge_map_clears_on_read_out;
    core.inlier_unit_clears_on_read_out = settings.inlier_unit_clears_on_read_out;
    core.has_line_buffers = settings.has_line_buffers;
    core.reciprocals_squeeze = settings.reciprocals_squeeze;
    core.area_reciprocal_interval = settings.area_reciprocal_interval;
    core.edge_map_ports = settings.ports[0];
    core.object_map_ports = settings.ports[1];
    core.depth_buffer_ports = settings.ports[2];
    core.setup_cycles = settings.setup_cycles;
    core.fifo_rules = settings.fifo_rules;
    for (std::size_t i = 0; i < settings.loops.size(); ++i) {
        core.loop_target[i] = settings.loops[i].target;
        core.loop_recurrence[i] = settings.loops[i].recurrence;
        core.loop_depth[i] = settings.loops[i].depth;
    }
    for (std::size_t i = 0; i < settings.fifos.size(); ++i) {
        core.fifo_kind[i] = settings.fifos[i].kind;
        core.fifo_depth[i] = settings.fifos[i].depth;
        core.fifo_write_latency[i] = settings.fifos[i].write_latency;
    }
}

template <class Word, class Memory> std::vector<Word> words_of(Memory const& memory, std::uint16_t window) {
    std::size_t const pixels = std::size_t{window} * window;
    std::vector<Word> words(pixels);
    for (std::size_t i = 0; i < pixels; ++i)
        words[i] = static_cast<Word>(memory[i]);
    return words;
}

}  // namespace

struct TwinCore::Parts {
    Stimulus const& stimulus;
    std::size_t first;
    std::size_t samples;
    std::uint16_t window;
    VerilatedContext context{};
    Vcosimulated_core core{&context};

    /// Answers what the registers ask for; then the logic of the cycle settles.
    void settle() {
        if (core.sample_number < samples) {
            SampleInput const& sample = stimulus.samples[first + core.sample_number];
            core.header_sample = static_cast<IData>(first + core.sample_number);
            core.header_centre_row = static_cast<IData>(sample.centre_row);
            core.header_centre_col = static_cast<IData>(sample.centre_col);
            core.header_triangles = sample.triangle_count;
        }
        answer_vertex();
        auto const row = static_cast<std::int32_t>(core.image_row);
        auto const col = static_cast<std::int32_t>(core.image_col);
        if (stimulus.observed_depth.contains(row, col)) {
            core.observed_depth = stimulus.observed_depth.at(row, col);
            core.observed_edge = stimulus.observed_edges.at(row, col);
        }
        core.clock = 0;
        core.eval();
    }

    void answer_vertex() {
        if (core.vertex_sample >= stimulus.samples.size())
            return;
        SampleInput const& sample = stimulus.samples[core.vertex_sample];
        if (core.vertex_number >= 3 * sample.triangle_count)
            return;
        VertexCode const& vertex =
            stimulus.triangles[sample.first_triangle + core.vertex_number / 3].vertex[core.vertex_number % 3];
        core.vertex_x = static_cast<SData>(vertex.x);
        core.vertex_y = static_cast<SData>(vertex.y);
        core.vertex_depth = vertex.z;
    }

    void edge() {
        core.clock = 1;
        core.eval();
    }
};

bool has_twin() { return true; }

TwinCore::TwinCore(TwinSettings const& settings, Stimulus const& stimulus, std::size_t first, std::size_t samples)
    : parts_(new Parts{stimulus, first, samples, settings.window}) {
    set(parts_->core, settings);
    parts_->core.samples = static_cast<IData>(samples);
    parts_->core.reset = 1;
    for (int cycle = 0; cycle < 2; ++cycle) {
        parts_->settle();
        parts_->edge();
    }
    parts_->core.reset = 0;
    parts_->settle();
}
TwinCore::~TwinCore() { parts_->core.final(); }

std::uint32_t TwinCore::writes() const { return parts_->core.fifo_write; }
std::uint32_t TwinCore::reads() const { return parts_->core.fifo_read; }
std::int64_t TwinCore::field(std::size_t fifo, std::size_t number) const {
    return static_cast<std::int64_t>(parts_->core.field[fifo][number]);
}

bool TwinCore::maps_are_built() const { return parts_->core.maps_are_built != 0; }
bool TwinCore::depth_buffer_is_drawn() const { return parts_->core.depth_buffer_is_drawn != 0; }

// The names that Verilator gives to the memories of the builder and the inlier unit.
std::vector<std::uint8_t> TwinCore::edge_map() const {
    return words_of<std::uint8_t>(
        parts_->core.rootp->cosimulated_core__DOT__core__DOT__builder__DOT__edge_map_ram__DOT__words, parts_->window);
}
std::vector<std::uint8_t> TwinCore::object_map() const {
    return words_of<std::uint8_t>(
        parts_->core.rootp->cosimulated_core__DOT__core__DOT__builder__DOT__object_map_ram__DOT__words, parts_->window);
}
std::vector<std::uint16_t> TwinCore::depth_buffer() const {
    return words_of<std::uint16_t>(
        parts_->core.rootp->cosimulated_core__DOT__core__DOT__inlier__DOT__depth_buffer_ram__DOT__words,
        parts_->window);
}

void TwinCore::step() {
    parts_->edge();
    parts_->settle();
}

}  // namespace faster::rtl
