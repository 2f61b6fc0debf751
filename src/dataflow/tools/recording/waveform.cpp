#include "dataflow/tools/recording/waveform.hpp"

#include <algorithm>
#include <cmath>

namespace dataflow::recording {

Waveform::Waveform(WaveformFiles const& files, double clock_mhz)
    : files_(files), ticks_per_cycle_(ticks_per_cycle(clock_mhz)) {}

void Waveform::open_scope(std::string const& name) {
    for (auto const& file : files_)
        file->open_scope(name);
}

void Waveform::close_scope() {
    for (auto const& file : files_)
        file->close_scope();
}

Waveform::Signal Waveform::add(SignalShape const& shape, std::size_t domain, Value value) {
    for (auto const& file : files_)
        file->declare(shape);
    Variable variable;
    variable.bits = static_cast<std::uint8_t>(shape.bits);
    variable.domain = static_cast<std::uint32_t>(domain);
    variables_.push_back(variable);
    set(variables_.size() - 1, value);
    return variables_.size() - 1;
}

void Waveform::add_clock() {
    for (SignalShape const& shape : {SignalShape{"clock", 1, {}}, SignalShape{"cycle", bits_of_cycle, {}}}) {
        for (auto const& file : files_)
            file->declare(shape);
        variables_.emplace_back().domain = ~std::uint32_t{0};
    }
    clock_ = variables_.size() - 2;
    number_ = variables_.size() - 1;
}

void Waveform::begin(std::vector<std::pair<Cycles, Cycles>> windows) {
    windows_ = std::move(windows);
    for (auto const& [first, last] : windows_)
        all_windows_ = {std::min(all_windows_.first, first), std::max(all_windows_.second, last)};
    for (auto const& file : files_)
        file->end_declarations();
}

void Waveform::touch(Signal signal) {
    if (variables_[signal].is_dirty)
        return;
    variables_[signal].is_dirty = true;
    dirty_.push_back(signal);
}

void Waveform::touch_domain(std::size_t domain) {
    for (Signal signal = 0; signal < variables_.size(); ++signal)
        if (variables_[signal].domain == domain)
            touch(signal);
}

void Waveform::set(Signal signal, Value value) {
    Variable& variable = variables_[signal];
    std::uint64_t const mask = variable.bits == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << variable.bits) - 1;
    variable.value = value ? Bits(static_cast<std::uint64_t>(*value) & mask) : std::nullopt;
    touch(signal);
}

void Waveform::schedule(Cycles cycle, Signal signal, Value value) {
    if (cycle - cycle_ < ring_size) {
        ring_[cycle % ring_size].push_back({signal, value});
        ++in_ring_;
    } else {
        later_.push({cycle, scheduled_++, signal, value});
    }
}

/// The next cycle, up to `cycle`, in which something may change: by a schedule, or because a window begins or is over.
Cycles Waveform::next_stop(Cycles cycle) const {
    Cycles stop = std::min(cycle, next_border_);
    if (!later_.empty())
        stop = std::min(stop, later_.top().cycle);
    if (in_ring_ > 0)
        for (Cycles near = cycle_ + 1; near < stop && near < cycle_ + ring_size; ++near)
            if (!ring_[near % ring_size].empty())
                return near;
    return std::max(stop, cycle_ + 1);
}

void Waveform::cross_border() {
    next_border_ = ~Cycles{0};
    for (std::size_t domain = 0; domain < windows_.size(); ++domain)
        for (Cycles const border : {windows_[domain].first, windows_[domain].second + 1}) {
            if (border == cycle_)
                touch_domain(domain);
            else if (border > cycle_)
                next_border_ = std::min(next_border_, border);
        }
}

void Waveform::advance(Cycles cycle) {
    while (cycle_ < cycle) {
        Cycles const stop = next_stop(cycle);
        flush_cycle();
        run_clock(stop);
        cycle_ = stop;
        if (cycle_ >= next_border_)
            cross_border();
        for (; !later_.empty() && later_.top().cycle <= cycle_; later_.pop())
            set(later_.top().signal, later_.top().value);
        std::vector<Change>& now = ring_[cycle_ % ring_size];
        in_ring_ -= now.size();
        for (Change const& change : now)
            set(change.signal, change.value);
        now.clear();
    }
}

std::uint64_t Waveform::ticks_of(Cycles cycle) const {
    return static_cast<std::uint64_t>(std::llround(static_cast<double>(cycle) * ticks_per_cycle_));
}

/// What changes in the cycle at hand. Before the first window nothing is written, and nothing is forgotten.
void Waveform::flush_cycle() {
    if (cycle_ < all_windows_.first || cycle_ > all_windows_.second + 1)
        return;
    std::sort(dirty_.begin(), dirty_.end());  // engines may tell of one cycle in another order
    go_to(ticks_of(cycle_));
    begin_cycle(cycle_);
    for (Signal const signal : dirty_) {
        Variable& variable = variables_[signal];
        variable.is_dirty = false;
        Bits const value = is_in(windows_[variable.domain]) ? variable.value : std::nullopt;
        if (variable.is_written && value == variable.written)
            continue;
        change(signal, value);
        variable.is_written = true;
        variable.written = value;
    }
    dirty_.clear();
}

/// To the end of the cycle before `until`.
void Waveform::run_clock(Cycles until) {
    std::uint64_t const half = static_cast<std::uint64_t>(ticks_per_cycle_ / 2);
    for (Cycles cycle = std::max(cycle_, all_windows_.first); cycle < until && cycle <= all_windows_.second; ++cycle) {
        if (cycle > cycle_) {
            go_to(ticks_of(cycle));
            begin_cycle(cycle);
        }
        go_to(ticks_of(cycle) + half);
        change(clock_, 0);
    }
}

/// Outside of all windows both are unknown.
void Waveform::begin_cycle(Cycles cycle) {
    bool const is_shown = cycle >= all_windows_.first && cycle <= all_windows_.second;
    change(clock_, is_shown ? Bits(1) : std::nullopt);
    change(number_, is_shown ? Bits(cycle) : std::nullopt);
}

void Waveform::go_to(std::uint64_t ticks) {
    for (auto const& file : files_)
        file->go_to(ticks);
}

void Waveform::change(Signal signal, Bits value) {
    for (auto const& file : files_)
        file->change(signal, value);
}

void Waveform::finish() {
    advance(all_windows_.second + 2);
    for (auto file = files_.rbegin(); file != files_.rend(); ++file)  // the first lets signals through
        (*file)->finish();
}

}  // namespace dataflow::recording
