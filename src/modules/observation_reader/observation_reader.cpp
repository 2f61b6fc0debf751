#include "modules/observation_reader/observation_reader.hpp"

#include <algorithm>

#include "channels/port_binding.hpp"
#include "faster/dataflow_names.hpp"
#include "modules/core/conditions.hpp"
#include "modules/core/memory_entries.hpp"
#include "modules/core/read_corners.hpp"
#include "modules/core/token_widths.hpp"

namespace faster {

ModuleDescription ObservationReader::describe(AcceleratorConfig const& config) {
    auto const lanes = static_cast<unsigned>(config.inlier_unit.sweep_lanes);
    ModuleDescription module("observation_reader");
    module.reads_from("sample_observation");
    module.reads_from("region").only_if(sweeps_touched_region(config));
    module.writes_to("valid_depth")
        .carries(
            "observed pixels of valid depth from the observation reader to the result collector (sweep_region: "
            "touched)")
        .of_bits(wires::pixel_count(config))
        .only_if(sweeps_touched_region(config));
    module.writes_to("observed_depth")
        .carries("observed depths from the observation reader to the inlier unit")
        .of_bits(wires::depth * lanes)
        .leaves("read", 4);
    module.writes_to("observed_edge")
        .carries("observed edge bits from the observation reader to the inlier unit")
        .of_bits(lanes)
        .leaves("read", 4);
    module.loop("read")
        .does("reads one token of observed pixels per iteration")
        .of_depth(5)
        .writes_to({"observed_depth", "observed_edge"})
        .accesses_memory("observation", widened({{{0, 0}}, {}}, static_cast<int>(lanes)));
    add_stream(config, module);
    return module;
}

/// On the chip, only the table of valid depths is outside. A region is not known before the sample is drawn.
void ObservationReader::add_stream(AcceleratorConfig const& config, ModuleDescription& module) {
    module.memory("observation")
        .holds("observed depths and edges of the image, if they are on the chip")
        .of_words(config.memory_placement.observation_height, config.memory_placement.observation_width,
                  wires::depth + 1)
        .shared_in_copies(config.memory_placement.observation_copies)
        .loaded_before()
        .only_if(has_external_memory(config))
        .only_if({config.memory_placement.observation == Placement::on_chip, "accelerator.memory.observation"});
    bool const reads_pixels = config.memory_placement.observation == Placement::external;
    module.fetches("observation")
        .brings("observed pixels, and words of the table of valid depths")
        .taken_by("read")
        .prefetches(sweeps_touched_region(config).holds ? timing::Prefetch::none : timing::Prefetch::handed)
        .only_if({reads_pixels || sweeps_touched_region(config).holds, "accelerator.memory.observation"});
}

ObservationReader::ObservationReader(sc_core::sc_module_name const& name, CoreContext const& core)
    : CoreModule(name, core) {
    if (core.sweeps_touched())
        valid_depth_.emplace(core.stimulus.observed_depth, core.stimulus.fraction.depth_buffer);
}

void ObservationReader::connect() {
    read_.connect(clock_, "read", &channel_of(observed_depth_out), &channel_of(observed_edge_out));
    if (core_.config.memory_placement.observation == Placement::external)
        read_.also_accesses(clock_.memory_port());
    table_read_.connect(clock_, "read");
    table_read_.also_accesses(clock_.memory_port());
}

void ObservationReader::start() {
    bool const knows_all = clock_.uses_memory() && !core_.sweeps_touched();
    for (std::size_t i = 0; knows_all && i < core_.sample_count; ++i)
        clock_.tell_entry(pixels_of(i, core_.window_rows()));
}

void ObservationReader::work(std::size_t i) {
    clock_.here();
    SampleHeader const header = sample_observation_in.read();
    clock_.advance(1);
    if (core_.sweeps_touched())
        send_valid_depth(i);
    LaneRows const rows = core_.rows_of(core_.sweeps_touched() ? receive_region() : core_.whole_window());
    if (clock_.uses_memory() && core_.sweeps_touched() && rows.tokens() > 0)
        clock_.tell_entry(pixels_of(i, rows));
    send_pixels(header, rows);
}

timing::MemoryEntry ObservationReader::pixels_of(std::size_t i, LaneRows const& rows) const {
    if (core_.config.memory_placement.observation == Placement::on_chip)
        return {i, {}};
    return pixel_entry(core_.config.memory_placement, i, core_.stimulus, core_.sample(i), rows);
}

/// Four reads of the table outside, through the pipeline that reads the pixels.
void ObservationReader::send_valid_depth(std::size_t i) {
    constexpr std::uint64_t reads = 4;
    SampleInput const& sample = core_.sample(i);
    if (clock_.uses_memory())
        clock_.tell_entry(table_entry(core_.config.memory_placement, i, core_.stimulus, sample));
    table_read_.run(reads, [](std::size_t /*first*/, std::size_t /*count*/) {});
    clock_.here();
    Stimulus const& stimulus = core_.stimulus;
    valid_depth_out->write(valid_depth_->count(stimulus.window_offset(sample.centre_row),
                                               stimulus.window_offset(sample.centre_col), stimulus.window));
    clock_.advance(1);
}

PixelBox ObservationReader::receive_region() {
    return box_of(read_corners(clock_, [this] { return region_in->read(); }));
}

void ObservationReader::send_pixels(SampleHeader const& header, LaneRows const& rows) {
    if (rows.tokens() == 0) {
        clock_.advance(1);
        return;
    }
    std::int64_t const first_row =
        core_.stimulus.window_offset(header.centre_row) + static_cast<std::int64_t>(rows.first_row());
    std::int64_t const first_col = core_.stimulus.window_offset(header.centre_col);
    read_.enter();
    for (std::int64_t row = first_row; row < first_row + static_cast<std::int64_t>(rows.rows()); ++row)
        read_.take(rows.tokens_per_row(),
                   [&](std::size_t first, std::size_t count, std::uint16_t* depth, std::uint8_t* edge) {
                       auto const col = static_cast<std::int64_t>(rows.first_col() + first * rows.lanes());
                       std::size_t const pixels = count * rows.lanes();
                       copy_row(core_.stimulus.observed_depth, row, first_col, col, pixels, depth);
                       copy_row(core_.stimulus.observed_edges, row, first_col, col, pixels, edge);
                   });
    read_.leave();
}

/// Pixels of a row of the window, from column `begin` of it on; what lies outside the image or the window reads as 0.
/// `first_col`: of the window.
template <class Pixel>
void ObservationReader::copy_row(Image<Pixel> const& image, std::int64_t row, std::int64_t first_col,
                                 std::int64_t begin, std::size_t pixels, Pixel* out) const {
    std::int64_t const end = std::min<std::int64_t>(core_.stimulus.window, begin + static_cast<std::int64_t>(pixels));
    std::int64_t const from = std::clamp<std::int64_t>(-first_col, begin, end);
    std::int64_t const to = std::clamp<std::int64_t>(image.width() - first_col, from, end);
    std::fill_n(out, pixels, Pixel{0});
    if (row >= 0 && row < image.height() && from < to)
        std::copy_n(image.row(static_cast<int>(row)) + first_col + from, to - from, out + (from - begin));
}

}  // namespace faster
