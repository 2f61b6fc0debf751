#include "kernel/recording/memory_signals.hpp"

#include <fmt/format.h>

namespace faster::recording {

MemorySignals::MemorySignals(Waveform& waveform, RecordedMemory const& memory, std::size_t domain)
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

}  // namespace faster::recording
