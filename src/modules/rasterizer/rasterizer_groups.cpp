#include <algorithm>

#include "faster/dataflow_names.hpp"
#include "modules/rasterizer/rasterizer_scan.hpp"

namespace faster {

/// Several pixels of a row per iteration. Only covered pixels are told of; a group without one is silent. Flattened, so
/// that lines stay in registers.
template <class Lines, bool Ahead>
[[gnu::flatten]] void RasterizerVariant::scan_groups(datapath::TriangleSetup const& setup) {
    command_->await_room();
    depth_groups_->await_room();
    index_groups_->await_room();
    if (edge_groups_ != nullptr)
        edge_groups_->await_room();
    for (Lines lines(setup); !lines.done();)
        send_groups<Lines, Ahead>({lines.next_line(), window_.row, window_.col, core_.config.rasterizer.lanes});
    command_->wake_reader();
    depth_groups_->wake_reader();
    index_groups_->wake_reader();
    if (edge_groups_ != nullptr)
        edge_groups_->wake_reader();
}

template <class Lines, bool Ahead> void RasterizerVariant::send_groups(datapath::GroupedLine const& line) {
    if (line.is_empty()) {
        iterate<Ahead>(timing::no_ports, static_cast<std::uint32_t>(Lines::skips_outside ? 1 : line.groups()));
        return;
    }
    if (!Lines::skips_outside)
        iterate<Ahead>(timing::no_ports, static_cast<std::uint32_t>(line.before()));
    send_group_tokens(line);
    iterate<Ahead>(ports_.fragment, static_cast<std::uint32_t>(line.inside()));
    if (!Lines::skips_outside)
        iterate<Ahead>(timing::no_ports, static_cast<std::uint32_t>(line.after()));
}

void RasterizerVariant::send_group_tokens(datapath::GroupedLine const& line) {
    auto const count = static_cast<std::size_t>(line.inside());
    Command* const command = command_->reserve(count);
    DepthGroup* const depth = depth_groups_->reserve(count);
    PixelGroup* const index = index_groups_->reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        command[i] = Command::Fragment;
        depth[i] = line.depths(static_cast<int>(i));
        index[i] = line.pixels(static_cast<int>(i));
    }
    if (touched_)
        touched_->add_run(line.row(), line.first_col(), line.last_col());
    if (edge_groups_ != nullptr) {
        std::copy_n(index, count, edge_groups_->reserve(count));
        edge_groups_->append(count);
    }
    command_->append(count);
    depth_groups_->append(count);
    index_groups_->append(count);
}

template void RasterizerVariant::scan_groups<datapath::ZigzagScan, false>(datapath::TriangleSetup const& setup);
template void RasterizerVariant::scan_groups<datapath::ZigzagScan, true>(datapath::TriangleSetup const& setup);
template void RasterizerVariant::scan_groups<datapath::EarlyExitScan, false>(datapath::TriangleSetup const& setup);
template void RasterizerVariant::scan_groups<datapath::EarlyExitScan, true>(datapath::TriangleSetup const& setup);
template void RasterizerVariant::scan_groups<datapath::SpanScan, false>(datapath::TriangleSetup const& setup);
template void RasterizerVariant::scan_groups<datapath::SpanScan, true>(datapath::TriangleSetup const& setup);

}  // namespace faster
