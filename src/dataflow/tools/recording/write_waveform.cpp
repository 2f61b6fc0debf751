#include "dataflow/tools/recording/write_waveform.hpp"

#include <algorithm>
#include <memory>
#include <optional>

#include "dataflow/tools/recording/core_signals.hpp"
#include "dataflow/tools/recording/memory_changes.hpp"

namespace dataflow::recording {

namespace {

constexpr Cycles cycles_between_reports = 1000;

class WaveformWriter {
  public:
    WaveformWriter(WaveformFiles const& files, Machine const& machine, RecordedWindow const& window,
                   SignalFilter const& filter)
        : waveform_(files, machine.clock_mhz), window_(window) {
        waveform_.open_scope("accelerator");
        waveform_.add_clock();
        for (RecordedCore const& core : window.cores) {
            cores_.push_back(std::make_unique<CoreSignals>(waveform_, core, filter, windows_.size()));
            windows_.emplace_back(core.from, core.to);
        }
        if (window.memory != nullptr && !window.cores.empty() && filter.shows_external_memory()) {
            memory_.emplace(waveform_, *window.memory, windows_.size());
            windows_.emplace_back(window.from(), window.to());
        }
        waveform_.close_scope();
    }

    void write(WritingProgress const& progress) {
        waveform_.begin(windows_);
        for (auto const& core : cores_)
            core->begin();
        std::vector<std::pair<std::size_t, Spools*>> spools;
        for (std::size_t i = 0; i < cores_.size(); ++i)
            spools.emplace_back(i, window_.cores[i].spools);
        Cycles reported = window_.from();
        for_each_event(spools, [&](CoreEvent const& event) {
            if (event.event.cycle > waveform_.cycle())
                go_to(event.event.cycle);
            cores_[event.core]->take(event);
            if (progress && waveform_.cycle() >= reported + cycles_between_reports) {
                reported = waveform_.cycle();
                progress(reported - window_.from(), window_.to() + 1 - window_.from());
            }
        });
        if (!windows_.empty())
            go_to(window_.to());
        waveform_.finish();
    }

  private:
    /// What happens by itself comes between events: tokens arrive, and the memory does what it was asked for.
    void go_to(Cycles cycle) {
        for (;;) {
            CoreSignals* first = nullptr;
            for (auto const& core : cores_)
                if (first == nullptr || core->next_arrival() < first->next_arrival())
                    first = core.get();
            Cycles const arrival = first == nullptr ? never : first->next_arrival();
            Cycles const change = memory_ ? memory_->next_change() : never;
            Cycles const next = std::min(arrival, change);
            if (next == never || next > cycle)
                break;
            waveform_.advance(std::max(waveform_.cycle(), next));
            arrival <= change ? first->arrive() : memory_->change();
        }
        waveform_.advance(std::max(waveform_.cycle(), cycle));
    }

    static constexpr Cycles never = ~Cycles{0};

    Waveform waveform_;
    RecordedWindow const& window_;
    std::vector<std::unique_ptr<CoreSignals>> cores_;
    std::optional<MemorySignals> memory_;
    std::vector<std::pair<Cycles, Cycles>> windows_;  // of the cores, and of the memory
};

}  // namespace

void write_waveform(WaveformFiles const& files, Machine const& machine, RecordedWindow const& window,
                    SignalFilter const& filter, WritingProgress const& progress) {
    WaveformWriter(files, machine, window, filter).write(progress);
}

}  // namespace dataflow::recording
