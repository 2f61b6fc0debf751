#pragma once
#include "modules/rasterizer/early_exit_scan.hpp"
#include "modules/rasterizer/rasterizer_variant.hpp"
#include "modules/rasterizer/span_scan.hpp"

// How the scans of RasterizerVariant tell what they do.

namespace faster {

/// Iterations of the scan. Those that a triangle begins with may have something else to do beside it.
template <bool Ahead> void RasterizerVariant::iterate(timing::Ports ports, std::uint32_t count) {
    if constexpr (Ahead)
        for (; ahead_.first_iterations > 0 && count > 0; --count)
            first_iteration(ports);
    clock_.iterate(ports, count);
}

/// A clock as tell_run() has it, whose iterations a triangle may begin with.
template <class Iterate> struct IterationsAhead {
    Iterate iterate;

    void iterate_with_tail(timing::Ports ports, std::uint32_t count, timing::Ports tail, std::uint32_t gap) const {
        iterate(ports, count);
        iterate(tail, 1);
        iterate(timing::no_ports, gap);
    }
    void iterate_flanked(timing::Ports ports, std::uint32_t count, timing::Ports tail, std::uint32_t gap) const {
        iterate_with_tail(ports, 1, tail, 0);
        iterate_with_tail(ports, count - 1, tail, gap);
    }
};
template <class Iterate> IterationsAhead(Iterate) -> IterationsAhead<Iterate>;

template <class Lines, bool Ahead> void RasterizerVariant::scan(datapath::TriangleSetup const& setup) {
    previous_ = window_.token(setup.start_row, setup.start_col, EdgeTokenKind::Edge);
    previous_inside_ = setup.starts_inside();
    burst_.begin(setup);
    Lines lines(setup);
    while (!lines.done())
        send_line<Lines, Ahead>(lines.next_line());
    end_burst();
}

/// Rasterizer::scan_line(), of lines that may leave out what lies outside.
template <class Lines, bool Ahead> void RasterizerVariant::send_line(datapath::ScanLine const& line) {
    int silent = line.before;
    if (previous_inside_ && silent > 0) {
        send_edge<Ahead>(window_.token(line.row, line.first_col, EdgeTokenKind::Edge));
        previous_inside_ = false;
        silent = Lines::skips_outside ? 0 : silent - 1;
    }
    if (Lines::skips_outside)
        silent = silent > 0 && line.inside == 0 ? 1 : 0;
    if (silent > 0)
        iterate<Ahead>(timing::no_ports, static_cast<std::uint32_t>(silent));
    if (line.before > 0)
        previous_ = window_.token(line.row, line.col(line.before - 1), EdgeTokenKind::Edge);
    if (line.inside > 0)
        send_run<Lines, Ahead>(line);
    else if (line.after > 0)
        iterate<Ahead>(timing::no_ports, static_cast<std::uint32_t>(line.after));
    previous_ = window_.token(line.row, line.col(line.pixels() - 1), EdgeTokenKind::Edge);
}

/// Rasterizer::scan_run(), of such lines.
template <class Lines, bool Ahead> void RasterizerVariant::send_run(datapath::ScanLine const& line) {
    bool const ends_here = line.last && line.inside == 1 && line.after == 0;
    bool const flushes = !previous_inside_ && !ends_here;
    bool const leaves = line.after > 0;
    burst_.write_run(line, window_, flushes ? &previous_ : nullptr, leaves);
    hand_over_in_lockstep();
    previous_inside_ = !leaves;
    RunIterations const run{line.inside, flushes, leaves, leaves && !Lines::skips_outside ? line.after - 1 : 0};
    if (Ahead && ahead_.first_iterations > 0)
        tell_run(IterationsAhead{[this](timing::Ports ports, std::uint32_t count) { iterate<Ahead>(ports, count); }},
                 ports_, run);
    else
        tell_run(clock_, ports_, run);
}

/// There, tokens have to be in the channels before the iterations that write them.
inline void RasterizerVariant::hand_over_in_lockstep() {
    if (clock_.lockstep())
        hand_over();
}

template <bool Ahead> void RasterizerVariant::send_edge(EdgeToken const& token) {
    burst_.write_edge(token);
    hand_over_in_lockstep();
    iterate<Ahead>(ports_.edge, 1);
}

extern template void RasterizerVariant::scan_groups<datapath::ZigzagScan, false>(datapath::TriangleSetup const& setup);
extern template void RasterizerVariant::scan_groups<datapath::ZigzagScan, true>(datapath::TriangleSetup const& setup);
extern template void RasterizerVariant::scan_groups<datapath::EarlyExitScan, false>(
    datapath::TriangleSetup const& setup);
extern template void RasterizerVariant::scan_groups<datapath::EarlyExitScan, true>(
    datapath::TriangleSetup const& setup);
extern template void RasterizerVariant::scan_groups<datapath::SpanScan, false>(datapath::TriangleSetup const& setup);
extern template void RasterizerVariant::scan_groups<datapath::SpanScan, true>(datapath::TriangleSetup const& setup);

}  // namespace faster
