#include "dataflow/tools/recording/memory_changes.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace dataflow::recording {

MemoryChanges::MemoryChanges(RecordedBursts const& memory) : memory_(memory), ports_(memory.shape.ports) {
    for (std::size_t port = 0; port < ports_.size(); ++port)
        ports_[port].bytes = memory.bytes_before[port];
}

Cycles MemoryChanges::next_cycle() const {
    Cycles const asked = next_ < memory_.bursts.size() ? memory_.bursts[next_].asked : ~Cycles{0};
    return changes_.empty() ? asked : std::min(asked, changes_.top().cycle);
}

void MemoryChanges::take_up(timing::ServedBurst const& burst) {
    std::uint64_t const period = memory_.shape.period_ps;
    auto const begun = static_cast<Cycles>(burst.begin_ps / period);
    auto const served = static_cast<Cycles>((burst.end_ps + period - 1) / period);
    changes_.push({burst.asked, Kind::asked, &burst});
    changes_.push({burst.first_beat, Kind::first_beat, &burst});
    changes_.push({burst.end(), Kind::done, &burst});
    changes_.push({burst.arrived, Kind::arrived, &burst});
    changes_.push({begun, Kind::begun, &burst});
    changes_.push({std::max(served, begun), Kind::served, &burst});
}

std::size_t MemoryChanges::go_on() {
    while (next_ < memory_.bursts.size() && (changes_.empty() || memory_.bursts[next_].asked <= changes_.top().cycle))
        take_up(memory_.bursts[next_++]);
    Change const change = changes_.top();
    changes_.pop();
    timing::ServedBurst const& burst = *change.burst;
    Port& port = ports_[burst.port];
    std::uint64_t const one_read = burst.is_write ? 0 : 1;
    switch (change.kind) {
        case Kind::asked:
            ++port.waiting;
            return burst.port;
        case Kind::first_beat:
            --port.waiting;
            port.reads += one_read;
            return burst.port;
        case Kind::done:
            port.reads -= one_read;
            port.bytes += burst.beats * memory_.shape.port_bytes;
            return burst.port;
        case Kind::arrived:
            ++controller_.queue;
            break;
        case Kind::begun:
            --controller_.queue;
            ++controller_.serving;
            break;
        case Kind::served:
            --controller_.serving;
            break;
    }
    return ports_.size();
}

MemorySignals::MemorySignals(Waveform& waveform, RecordedBursts const& memory, std::size_t domain)
    : waveform_(waveform), changes_(memory) {
    waveform_.open_scope("memory");
    for (std::size_t port = 0; port < changes_.ports().size(); ++port) {
        waveform_.open_scope(fmt::format("port_{}", port));
        ports_.push_back(
            {waveform_.add({"busy", 1, {}}, domain), waveform_.add({"waiting", 32, {}}, domain),
             waveform_.add({"bytes", 64, {}}, domain, static_cast<std::int64_t>(changes_.ports()[port].bytes))});
        waveform_.close_scope();
    }
    waveform_.open_scope("controller");
    controller_busy_ = waveform_.add({"busy", 1, {}}, domain);
    queue_ = waveform_.add({"queue", 32, {}}, domain);
    waveform_.close_scope();
    waveform_.close_scope();
}

void MemorySignals::change() {
    std::size_t const number = changes_.go_on();
    if (number == ports_.size()) {
        waveform_.set(controller_busy_, changes_.controller().serving > 0 ? 1 : 0);
        waveform_.set(queue_, static_cast<std::int64_t>(changes_.controller().queue));
        return;
    }
    MemoryChanges::Port const& port = changes_.ports()[number];
    waveform_.set(ports_[number].busy, port.reads > 0 ? 1 : 0);
    waveform_.set(ports_[number].waiting, static_cast<std::int64_t>(port.waiting));
    waveform_.set(ports_[number].bytes, static_cast<std::int64_t>(port.bytes));
}

}  // namespace dataflow::recording
