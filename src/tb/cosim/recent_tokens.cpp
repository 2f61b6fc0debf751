#include "tb/cosim/recent_tokens.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "kernel/recording/vcd_file.hpp"
#include "kernel/recording/write_waveform.hpp"

namespace faster::rtl {

namespace {

using Kind = recording::Event::Kind;

recording::Event access(Kind kind, std::size_t fifo, Cycles cycle, std::int64_t value = 0) {
    recording::Event event;
    event.kind = kind;
    event.item = static_cast<std::uint32_t>(fifo);
    event.cycle = cycle;
    event.value = value;
    return event;
}

}  // namespace

/// A token that was read stays for a while, as what was read last can be seen until the next is.
void RecentTokens::read(std::size_t fifo, Cycles cycle) {
    std::deque<Token>& tokens = tokens_[fifo];
    auto const oldest = std::find_if(tokens.begin(), tokens.end(), [](Token const& token) { return !token.read; });
    if (oldest == tokens.end())
        throw std::logic_error("a read of an empty FIFO");
    oldest->read = cycle;
    while (tokens.size() > 1 && tokens[1].read && *tokens[1].read + kept_cycles < cycle)
        tokens.pop_front();
}

recording::Spools RecentTokens::spools_of(Machine const& machine) const {
    std::vector<std::vector<recording::Event>> events(machine.processes.size());
    for (std::size_t fifo = 0; fifo < tokens_.size(); ++fifo)
        for (Token const& token : tokens_[fifo]) {
            std::vector<recording::Event>& writes = events[machine.fifos[fifo].writer];
            for (std::size_t i = 0; i < token.values.size(); ++i)
                writes.push_back(access(i == 0 ? Kind::write : Kind::field, fifo, token.written, token.values[i]));
            if (token.read)
                events[machine.fifos[fifo].reader].push_back(access(Kind::read, fifo, *token.read));
        }
    recording::Spools spools(events.size());
    for (std::size_t process = 0; process < events.size(); ++process) {
        std::stable_sort(events[process].begin(), events[process].end(),
                         [](auto const& a, auto const& b) { return a.cycle < b.cycle; });
        for (recording::Event const& event : events[process])
            spools[process].put(event);
        spools[process].rewind();
    }
    return spools;
}

void RecentTokens::write_vcd(std::filesystem::path const& file, recording::RecordedCore const& core, Cycles from,
                             Cycles to) const {
    recording::Spools spools = spools_of(*core.machine);
    recording::RecordedCore shown = core;
    shown.from = from;
    shown.to = to;
    shown.memory_activity = nullptr;
    shown.spools = &spools;
    recording::RecordedWindow window;
    window.cores.push_back(shown);
    recording::WaveformFiles files;
    files.push_back(std::make_unique<recording::VcdFile>(file, core.machine->clock_mhz));
    recording::write_waveform(files, *core.machine, window, recording::SignalFilter::fifos(*core.machine));
}

}  // namespace faster::rtl
