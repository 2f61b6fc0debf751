#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <queue>
#include <string>
#include <utility>
#include <vector>

#include "dataflow/base/cycles.hpp"
#include "dataflow/tools/recording/waveform_file.hpp"

namespace dataflow::recording {

/// Written at once. The last goes first: the first lets the signals through that they hold back (HeldSignals).
struct WaveformFiles : std::vector<std::unique_ptr<WaveformFile>> {
    WaveformFiles() = default;
    WaveformFiles(WaveformFiles const&) = delete;
    WaveformFiles& operator=(WaveformFiles const&) = delete;
    ~WaveformFiles() {
        while (!empty())
            pop_back();
    }
};

/// The signals of a waveform, cycle by cycle, with a clock, which rises where a cycle begins, and the cycle's number.
/// Values are set; of several in one cycle the last counts, and what does not change is not written. Signals belong to
/// domains, each with a window of cycles of its own, outside of which they read as unknown.
class Waveform {
  public:
    using Signal = std::size_t;
    /// None: unknown.
    using Value = std::optional<std::int64_t>;

    /// Writes the same into all files.
    Waveform(WaveformFiles const& files, double clock_mhz);

    void open_scope(std::string const& name);
    void close_scope();
    Signal add(SignalShape const& shape, std::size_t domain, Value value = 0);
    /// Where the clock and the number of the cycle stand among the signals.
    void add_clock();
    /// Ends the declarations. `windows`: first and last cycle of each domain.
    void begin(std::vector<std::pair<Cycles, Cycles>> windows);

    /// Moves on to a cycle; what was scheduled up to it happens.
    void advance(Cycles cycle);
    void set(Signal signal, Value value);
    /// As set(), later.
    void schedule(Cycles cycle, Signal signal, Value value);
    /// In this cycle or a later one.
    void set_at(Cycles cycle, Signal signal, Value value) {
        if (cycle <= cycle_)
            set(signal, value);
        else
            schedule(cycle, signal, value);
    }
    /// 1 in this cycle only.
    void pulse(Signal signal) {
        set(signal, 1);
        schedule(cycle_ + 1, signal, 0);
    }
    Cycles cycle() const { return cycle_; }
    /// Writes the rest and finishes the files.
    void finish();

  private:
    using Bits = std::optional<std::uint64_t>;
    struct Variable {
        Bits value;
        Bits written;
        std::uint32_t domain = 0;
        std::uint8_t bits = 1;
        bool is_written = false;
        bool is_dirty = false;
    };
    struct Later {
        Cycles cycle;
        std::uint64_t order;  ///< of scheduling: first come, first served
        Signal signal;
        Value value;
        bool operator>(Later const& other) const {
            return cycle != other.cycle ? cycle > other.cycle : order > other.order;
        }
    };
    void flush_cycle();
    void run_clock(Cycles until);
    void begin_cycle(Cycles cycle);
    void go_to(std::uint64_t ticks);
    void change(Signal signal, Bits value);
    void touch(Signal signal);
    void touch_domain(std::size_t domain);
    Cycles next_stop(Cycles cycle) const;
    void cross_border();
    std::uint64_t ticks_of(Cycles cycle) const;
    bool is_in(std::pair<Cycles, Cycles> const& window) const {
        return cycle_ >= window.first && cycle_ <= window.second;
    }

    WaveformFiles const& files_;
    double ticks_per_cycle_;
    std::vector<Variable> variables_;
    Signal clock_ = 0;
    Signal number_ = 0;
    std::vector<Signal> dirty_;
    std::vector<std::pair<Cycles, Cycles>> windows_;  // by domain
    std::pair<Cycles, Cycles> all_windows_{~Cycles{0}, 0};
    // Nearly all is scheduled for one of the next few cycles: a ring of them, and a queue for what is further away.
    static constexpr std::size_t ring_size = 8;
    struct Change {
        Signal signal;
        Value value;
    };
    std::array<std::vector<Change>, ring_size> ring_;
    std::size_t in_ring_ = 0;
    std::priority_queue<Later, std::vector<Later>, std::greater<>> later_;
    std::uint64_t scheduled_ = 0;
    Cycles next_border_ = 0;
    Cycles cycle_ = 0;
};

}  // namespace dataflow::recording
