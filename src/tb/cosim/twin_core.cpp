#include "tb/cosim/twin_core.hpp"

#include <Vcosimulated_core.h>
#include <Vcosimulated_core___024root.h>
#include <Vcosimulated_lane_core.h>
#include <iterator>

namespace faster::rtl {

namespace {

/// What both have; the rest differs.
template <class Core> void set_common(Core& core, TwinSettings const& settings) {
    core.width = settings.width;
    core.height = settings.height;
    core.window = settings.window;
    core.vertex_xy = static_cast<CData>(settings.fraction.vertex_xy);
    core.vertex_z = static_cast<CData>(settings.fraction.vertex_z);
    core.area_reciprocal_fraction = static_cast<CData>(settings.fraction.area_reciprocal);
    core.fragment_depth_fraction = static_cast<CData>(settings.fraction.fragment_depth);
    core.depth_buffer_fraction = static_cast<CData>(settings.fraction.depth_buffer);
    core.forwards_depth_buffer = settings.forwards;
    core.reciprocals_squeeze = settings.reciprocals_squeeze;
    core.counts_hidden = settings.counts_hidden;
    core.area_reciprocal_interval = settings.area_reciprocal_interval;
    core.object_map_ports = settings.ports[1];
    core.depth_buffer_ports = settings.ports[2];
    core.setup_cycles = settings.setup_cycles;
    core.fifo_rules = settings.fifo_rules;
    for (std::size_t i = 0; i < settings.loops.size(); ++i) {
        core.loop_target[i] = settings.loops[i].target;
        core.loop_recurrence[i] = settings.loops[i].recurrence;
        core.loop_depth[i] = settings.loops[i].depth;
    }
    for (std::size_t i = 0; i < std::size(core.fifo_kind); ++i) {
        core.fifo_kind[i] = settings.fifos[i].kind;
        core.fifo_depth[i] = settings.fifos[i].depth;
        core.fifo_write_latency[i] = settings.fifos[i].write_latency;
    }
}

/// Pixels of the window whose observed depth is at most 3 m, but for its border.
std::uint32_t valid_depths(Stimulus const& stimulus, SampleInput const& sample) {
    int const top = stimulus.near_window_offset(sample.centre_row);
    int const left = stimulus.near_window_offset(sample.centre_col);
    std::uint32_t count = 0;
    for (int row = 1; row + 1 < stimulus.window; ++row)
        for (int col = 1; col + 1 < stimulus.window; ++col) {
            unsigned const depth = stimulus.observed_depth.contains(top + row, left + col)
                                       ? stimulus.observed_depth.at(top + row, left + col)
                                       : 0U;
            count += depth <= 3U << stimulus.fraction.depth_buffer ? 1U : 0U;
        }
    return count;
}

template <class Core> class Verilated : public TwinCore {
  public:
    Verilated(TwinSettings const& settings, Stimulus const& stimulus, std::size_t first, std::size_t samples)
        : stimulus_(stimulus), first_(first), samples_(samples), window_(settings.window) {
        set_common(core_, settings);
        core_.samples = static_cast<IData>(samples);
    }
    ~Verilated() override { core_.final(); }

    void start() {
        core_.reset = true;
        for (int cycle = 0; cycle < 2; ++cycle) {
            settle();
            edge();
        }
        core_.reset = false;
        settle();
    }
    void step() override {
        edge();
        settle();
    }
    std::uint32_t writes() const override { return core_.fifo_write; }
    std::uint32_t reads() const override { return core_.fifo_read; }
    std::int64_t field(std::size_t fifo, std::size_t number) const override {
        return static_cast<std::int64_t>(core_.field[fifo][number]);
    }
    bool maps_are_built() const override { return core_.maps_are_built != 0; }
    bool depth_buffer_is_drawn() const override { return core_.depth_buffer_is_drawn != 0; }

  protected:
    virtual void answer_observation() = 0;

    std::size_t pixels() const { return std::size_t{window_} * window_; }

    Stimulus const& stimulus_;
    std::size_t first_;
    std::size_t samples_;
    std::uint16_t window_;
    VerilatedContext context_{};
    Core core_{&context_};

  private:
    /// Answers what the registers ask for; then the logic of the cycle settles.
    void settle() {
        if (core_.sample_number < samples_) {
            SampleInput const& sample = stimulus_.samples[first_ + core_.sample_number];
            core_.header_sample = static_cast<IData>(first_ + core_.sample_number);
            core_.header_centre_row = static_cast<IData>(sample.centre_row);
            core_.header_centre_col = static_cast<IData>(sample.centre_col);
            core_.header_triangles = sample.triangle_count;
        }
        answer_vertex();
        answer_observation();
        core_.clock = 0;
        core_.eval();
    }
    void edge() {
        core_.clock = 1;
        core_.eval();
    }
    void answer_vertex() {
        if (core_.vertex_sample >= stimulus_.samples.size())
            return;
        SampleInput const& sample = stimulus_.samples[core_.vertex_sample];
        if (core_.vertex_number >= 3 * sample.triangle_count)
            return;
        VertexCode const& vertex =
            stimulus_.triangles[sample.first_triangle + core_.vertex_number / 3].vertex[core_.vertex_number % 3];
        core_.vertex_x = static_cast<SData>(vertex.x);
        core_.vertex_y = static_cast<SData>(vertex.y);
        core_.vertex_depth = vertex.z;
    }
};

/// rtl/raster_core.sv
class RasterCoreTwin final : public Verilated<Vcosimulated_core> {
  public:
    RasterCoreTwin(TwinSettings const& settings, Stimulus const& stimulus, std::size_t first, std::size_t samples)
        : Verilated(settings, stimulus, first, samples) {
        core_.sends_edges = settings.sends_edges;
        core_.is_inner_border = settings.is_inner_border;
        core_.flushes_last = settings.flushes_last;
        core_.forwards_object_map = settings.forwards;
        core_.fragment_loop_is_flattened = settings.is_flattened;
        core_.edge_map_clears_on_read_out = settings.edge_map_clears_on_read_out;
        core_.inlier_unit_clears_on_read_out = settings.inlier_unit_clears_on_read_out;
        core_.has_line_buffers = settings.has_line_buffers;
        core_.edge_map_ports = settings.ports[0];
    }
    // The names that Verilator gives to the memories of the builder and the inlier unit.
    std::vector<std::uint8_t> edge_map() override {
        return words_of<std::uint8_t>(
            core_.rootp->cosimulated_core__DOT__core__DOT__builder__DOT__edge_map_ram__DOT__words);
    }
    std::vector<std::uint8_t> object_map() override {
        return words_of<std::uint8_t>(
            core_.rootp->cosimulated_core__DOT__core__DOT__builder__DOT__object_map_ram__DOT__words);
    }
    std::vector<std::uint16_t> depth_buffer() override {
        return words_of<std::uint16_t>(
            core_.rootp->cosimulated_core__DOT__core__DOT__inlier__DOT__depth_buffer_ram__DOT__words);
    }

  private:
    void answer_observation() override {
        auto const row = static_cast<std::int32_t>(core_.image_row);
        auto const col = static_cast<std::int32_t>(core_.image_col);
        if (stimulus_.observed_depth.contains(row, col)) {
            core_.observed_depth = stimulus_.observed_depth.at(row, col);
            core_.observed_edge = stimulus_.observed_edges.at(row, col);
        }
    }
    template <class Word, class Memory> std::vector<Word> words_of(Memory const& memory) const {
        std::vector<Word> words(pixels());
        for (std::size_t i = 0; i < words.size(); ++i)
            words[i] = static_cast<Word>(memory[i]);
        return words;
    }
};

/// rtl/lanes/lane_core.sv
class LaneCoreTwin final : public Verilated<Vcosimulated_lane_core> {
  public:
    LaneCoreTwin(TwinSettings const& settings, Stimulus const& stimulus, std::size_t first, std::size_t samples)
        : Verilated(settings, stimulus, first, samples), lanes_(*settings.lanes) {
        core_.scan_lanes = lanes_.scan;
        core_.sweep_lanes = lanes_.sweep;
        core_.object_map_banks = lanes_.object_map_banks;
        core_.depth_buffer_banks = lanes_.depth_buffer_banks;
        core_.setups_ahead = lanes_.setups_ahead;
        core_.sweeps_touched = lanes_.sweeps_touched;
        core_.has_two_maps = lanes_.has_two_maps;
        core_.has_two_depth_buffers = lanes_.has_two_depth_buffers;
    }
    std::vector<std::uint8_t> edge_map() override { return {}; }  // there is none
    std::vector<std::uint8_t> object_map() override {
        return words_of<std::uint8_t>(core_.object_words, lanes_.object_map_banks);
    }
    std::vector<std::uint16_t> depth_buffer() override {
        return words_of<std::uint16_t>(core_.depth_words, lanes_.depth_buffer_banks);
    }

  private:
    void answer_observation() override {
        auto const row = static_cast<std::int32_t>(core_.image_row);
        for (std::uint8_t lane = 0; lane < lanes_.sweep; ++lane) {
            std::int32_t const col = static_cast<std::int32_t>(core_.image_col) + lane;
            if (stimulus_.observed_depth.contains(row, col)) {
                core_.observed_depth[lane] = stimulus_.observed_depth.at(row, col);
                core_.observed_edge[lane] = stimulus_.observed_edges.at(row, col);
            }
        }
        if (lanes_.sweeps_touched && core_.observed_sample != counted_sample_ &&
            core_.observed_sample < stimulus_.samples.size()) {
            counted_sample_ = core_.observed_sample;
            core_.valid_depths = valid_depths(stimulus_, stimulus_.samples[counted_sample_]);
        }
    }
    /// A word of every bank at a time.
    template <class Word, class Words> std::vector<Word> words_of(Words const& of_banks, std::size_t banks) {
        std::size_t const bank_cols = (window_ + banks - 1) / banks;
        std::vector<Word> words(pixels());
        for (std::size_t i = 0; i < words.size(); ++i) {
            std::size_t const row = i / window_;
            std::size_t const col = i % window_;
            if (auto const address = static_cast<SData>(row * bank_cols + col / banks);
                col % banks == 0 || address != core_.bank_address) {
                core_.bank_address = address;
                core_.eval();
            }
            words[i] = static_cast<Word>(of_banks[col % banks]);
        }
        return words;
    }

    TwinSettings::Lanes lanes_;
    IData counted_sample_ = ~IData{0};
};

template <class Twin, class... Arguments> std::unique_ptr<TwinCore> started(Arguments const&... arguments) {
    auto twin = std::make_unique<Twin>(arguments...);
    twin->start();
    return twin;
}

}  // namespace

bool has_twin() { return true; }

std::unique_ptr<TwinCore> make_twin(TwinSettings const& settings, Stimulus const& stimulus, std::size_t first,
                                    std::size_t samples) {
    return settings.lanes ? started<LaneCoreTwin>(settings, stimulus, first, samples)
                          : started<RasterCoreTwin>(settings, stimulus, first, samples);
}

}  // namespace faster::rtl
