#pragma once
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace dataflow::recording {

/// A signal as a file declares it.
struct SignalShape {
    std::string name;
    unsigned bits = 1;
    std::vector<std::string> values;  ///< what 0, 1, 2, ... mean; empty: a number
};

/// A format of waveforms. Declarations come first; signals are numbered from 0 on in their order. Then changes, time by
/// time. The file appears when it is finished, not before. Errors: InputError if it cannot be written.
class WaveformFile {
  public:
    virtual ~WaveformFile() = default;

    virtual void open_scope(std::string const& name) = 0;
    virtual void close_scope() = 0;
    virtual void declare(SignalShape const& shape) = 0;
    virtual void end_declarations() = 0;
    /// What changes from here on does so at that time, in ticks.
    virtual void go_to(std::uint64_t ticks) = 0;
    /// No value: unknown.
    virtual void change(std::size_t signal, std::optional<std::uint64_t> value) = 0;
    virtual void finish() = 0;
    /// Once it is finished: how long it is.
    virtual std::uint64_t bytes() const = 0;
};

/// Whether a tick, a waveform's unit of time, is a nanosecond: if a cycle is a whole number of them. Otherwise a
/// picosecond.
inline bool counts_in_ns(double clock_mhz) {
    double const ns = 1e3 / clock_mhz;
    return ns > 1.5 && std::abs(ns - std::round(ns)) < 1e-9;  // half a cycle is no whole unit of one
}
inline double ticks_per_cycle(double clock_mhz) {
    return counts_in_ns(clock_mhz) ? std::round(1e3 / clock_mhz) : 1e6 / clock_mhz;
}

/// Of the signal that has the number of the cycle.
constexpr unsigned bits_of_cycle = 48;

/// Bits of a signal that shows numbers up to the largest.
inline unsigned signal_bits(std::uint64_t largest) {
    return largest == 0 ? 1 : 64U - static_cast<unsigned>(__builtin_clzll(largest));
}

}  // namespace dataflow::recording
