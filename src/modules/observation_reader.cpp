#include "modules/observation_reader.hpp"

#include <algorithm>

#include "channels/port_binding.hpp"
#include "modules/core_shapes.hpp"

namespace faster {

ObservationReader::ObservationReader(sc_core::sc_module_name const& name, CoreContext const& core)
    : sc_module(name), core_(core), clock_(core.timing, basename(), core.time_base) {
    SC_THREAD(run);
}

void ObservationReader::end_of_elaboration() {
    clock_.connect_reads(channel_of(sample_observation_in));
    clock_.connect_writes(channel_of(observed_depth_out));
    clock_.connect_writes(channel_of(observed_edge_out));
    read_loop_ = clock_.add_loop(loop_shape(LoopId::read, core_.config),
                                 {&channel_of(observed_depth_out), &channel_of(observed_edge_out)});
}

void ObservationReader::run() {
    for (std::size_t i = 0; i < core_.sample_count; ++i) {
        core_.begin_sample(ModuleId::observation_reader);
        clock_.here();
        SampleHeader const header = sample_observation_in.read();
        clock_.advance(1);
        send_window(header);
    }
}

void ObservationReader::send_window(SampleHeader const& header) {
    auto& depth = channel_of(observed_depth_out);
    auto& edge = channel_of(observed_edge_out);
    auto const ports = static_cast<std::uint8_t>(depth.write_port() | edge.write_port());
    std::size_t const tokens = core_.window_rows().tokens_per_row();
    std::int64_t const first_row = core_.window_offset(header.centre_row);
    std::int64_t const first_col = core_.window_offset(header.centre_col);
    clock_.enter_loop(read_loop_);
    for (std::int64_t row = first_row; row < first_row + core_.stimulus.window; ++row) {
        depth.await_room();
        edge.await_room();
        copy_row(core_.stimulus.observed_depth, row, first_col, depth.reserve(tokens));
        copy_row(core_.stimulus.observed_edges, row, first_col, edge.reserve(tokens));
        depth.commit(tokens);
        edge.commit(tokens);
        clock_.iterate(ports, tokens);
    }
    clock_.leave_loop();
}

/// One row of the window, in whole tokens; what lies outside the image or the window reads as 0.
template <class Pixel>
void ObservationReader::copy_row(Image<Pixel> const& image, std::int64_t row, std::int64_t first_col,
                                 Pixel* out) const {
    std::int64_t const side = core_.stimulus.window;
    std::int64_t const from = std::clamp<std::int64_t>(-first_col, 0, side);
    std::int64_t const to = std::clamp<std::int64_t>(image.width() - first_col, from, side);
    std::fill_n(out, core_.window_rows().tokens_per_row() * core_.window_rows().lanes(), Pixel{0});
    if (row >= 0 && row < image.height() && from < to)
        std::copy_n(image.row(static_cast<int>(row)) + first_col + from, to - from, out + from);
}

}  // namespace faster
