#include "dataflow/lookup/bench_process.hpp"

#include <algorithm>

namespace dataflow::timing {

BenchProcess::BenchProcess(ProcessTiming const& process, FigureBlock* figures, Trail* trail)
    : Rules(process.fed_shape(), process.index()), ports_(process.port_count()) {
    trail_ = trail;
    for (LoopShape const& loop : shape_->loops) {
        figures_.push_back({figures, RelativeState::blocks_of(loop)});
        figures += figures_.back().blocks;
    }
    awaited_setups_ = figures;
}

StateWord const* BenchProcess::load(StateWord const* words) {
    if (!log_.exhausted())
        log_.clear();
    ProcessFlags flags;
    words = load_process<Rules>(*this, 0, words, flags);
    outlook_ports_ = flags.next_ports;
    frozen_ = flags.frozen;
    parked_at_ = flags.waits_at - 1;
    return words;
}

void BenchProcess::save(StatePage& page) {
    ProcessFlags flags;
    flags.next_ports = outlook_ports_;
    flags.frozen = frozen_;
    flags.waits_at = parked_at_ + 1;
    save_process<Rules>(*this, flags, true, page);
}

void BenchProcess::count_end() {
    LoopFigures const& figures = figures_[state_.loop];
    counted_ |= 1U << state_.loop;
    LoopEnd const end = loop_end(shape_->loops[state_.loop], state_.iterations);
    figures.first->sums[0] += static_cast<std::uint32_t>(end.entries);
    if (figures.blocks == 1)
        return;
    FigureBlock& beyond_end = figures.first[1];
    beyond_end.sums[0] += static_cast<std::uint32_t>(end.recurrence_beyond_end);
    beyond_end.sums[1] += static_cast<std::uint32_t>(end.port_conflict_beyond_end);
}

}  // namespace dataflow::timing
