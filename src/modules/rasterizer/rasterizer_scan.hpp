#pragma once
#include "modules/rasterizer/early_exit_scan.hpp"
#include "modules/rasterizer/rasterizer.hpp"
#include "modules/rasterizer/span_scan.hpp"

// How a scan tells what it does. For the files that instantiate it: rasterizer.cpp for the thesis's design alone, so
// that the compiler spends on it what it allows itself per file; rasterizer_variants.cpp for all others.

namespace faster {

/// Iterations of the scan. Those that a triangle begins with may have something else to do beside it.
template <bool Ahead> void Rasterizer::iterate(timing::Ports ports, std::uint32_t count) {
    if constexpr (Ahead)
        for (; ahead_.first_iterations > 0 && count > 0; --count)
            first_iteration(ports);
    clock_.iterate(ports, count);
}

template <bool Ahead>
void Rasterizer::iterate_with_tail(timing::Ports ports, std::uint32_t count, timing::Ports tail_ports,
                                   std::uint32_t tail_gap) {
    if (Ahead && ahead_.first_iterations > 0) {
        iterate<Ahead>(ports, count);
        iterate<Ahead>(tail_ports, 1);
        iterate<Ahead>(timing::no_ports, tail_gap);
    } else {
        clock_.iterate_with_tail(ports, count, tail_ports, tail_gap);
    }
}

template <bool Ahead>
void Rasterizer::iterate_flanked(timing::Ports ports, std::uint32_t count, timing::Ports tail_ports,
                                 std::uint32_t tail_gap) {
    if (Ahead && ahead_.first_iterations > 0) {
        iterate_with_tail<Ahead>(ports, 1, tail_ports, 0);
        iterate_with_tail<Ahead>(ports, count - 1, tail_ports, tail_gap);
    } else {
        clock_.iterate_flanked(ports, count, tail_ports, tail_gap);
    }
}

template <class Lines, bool Ahead> void Rasterizer::scan(datapath::TriangleSetup const& setup) {
    previous_row_ = setup.start_row;
    previous_col_ = setup.start_col;
    previous_inside_ = setup.starts_inside();
    begin_burst(setup);
    Lines lines(setup);
    while (!lines.done())
        send_line<Lines, Ahead>(lines.next_line());
    end_burst();
}

/// The iterations of one line: pixels outside are silent but for the first after the inside run, which is an edge.
template <class Lines, bool Ahead> void Rasterizer::send_line(datapath::ScanLine const& line) {
    int silent = line.before;
    if (previous_inside_ && silent > 0) {  // the run ended with the last line
        send_edge<Ahead>(line.row, line.first_col);
        previous_inside_ = false;
        silent = Lines::skips_outside ? 0 : silent - 1;
    }
    if (Lines::skips_outside)
        silent = silent > 0 && line.inside == 0 ? 1 : 0;
    if (silent > 0)
        iterate<Ahead>(timing::no_ports, static_cast<std::uint32_t>(silent));
    if (line.before > 0) {
        previous_row_ = line.row;
        previous_col_ = line.col(line.before - 1);
    }
    if (line.inside > 0)
        send_run<Lines, Ahead>(line);
    else if (line.after > 0)
        iterate<Ahead>(timing::no_ports, static_cast<std::uint32_t>(line.after));
    previous_row_ = line.row;
    previous_col_ = line.col(line.pixels() - 1);
}

/// The run of covered pixels, and the edge behind it. Where the scan comes in from outside, the pixel before is an edge
/// as well; it is sent by an iteration of its own after the first covered pixel, unless the triangle ends there (as in
/// A.1, which then loses it).
template <class Lines, bool Ahead> void Rasterizer::send_run(datapath::ScanLine const& line) {
    auto const count = static_cast<std::uint32_t>(line.inside);
    bool const ends_here = line.last && line.inside == 1 && line.after == 0;
    bool const flushes = !previous_inside_ && !ends_here;
    bool const leaves = line.after > 0;
    send_tokens(line, flushes, leaves);
    previous_inside_ = !leaves;
    auto const silent = static_cast<std::uint32_t>(leaves && !Lines::skips_outside ? line.after - 1 : 0);
    if (flushes && leaves && count > 1) {
        iterate_flanked<Ahead>(fragment_ports_, count, edge_port_, silent);
        return;
    }
    if (flushes)
        iterate_with_tail<Ahead>(fragment_ports_, 1, edge_port_, 0);
    std::uint32_t const rest = flushes ? count - 1 : count;
    if (leaves && rest > 0) {
        iterate_with_tail<Ahead>(fragment_ports_, rest, edge_port_, silent);
    } else if (leaves) {
        iterate<Ahead>(edge_port_, 1);
        iterate<Ahead>(timing::no_ports, silent);
    } else {
        iterate<Ahead>(fragment_ports_, rest);
    }
}

template <bool Ahead> void Rasterizer::send_edge(int row, int col) {
    *burst_.token++ = token_at(row, col, EdgeTokenKind::Edge);
    if (clock_.lockstep())
        hand_over();
    iterate<Ahead>(edge_port_, 1);
}

extern template void Rasterizer::scan<datapath::ZigzagScan, false>(datapath::TriangleSetup const& setup);
extern template void Rasterizer::scan_groups<datapath::ZigzagScan, false>(datapath::TriangleSetup const& setup);
extern template void Rasterizer::scan_groups<datapath::ZigzagScan, true>(datapath::TriangleSetup const& setup);
extern template void Rasterizer::scan_groups<datapath::EarlyExitScan, false>(datapath::TriangleSetup const& setup);
extern template void Rasterizer::scan_groups<datapath::EarlyExitScan, true>(datapath::TriangleSetup const& setup);
extern template void Rasterizer::scan_groups<datapath::SpanScan, false>(datapath::TriangleSetup const& setup);
extern template void Rasterizer::scan_groups<datapath::SpanScan, true>(datapath::TriangleSetup const& setup);

}  // namespace faster
