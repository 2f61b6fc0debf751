#pragma once
#include <array>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <queue>
#include <string>
#include <vector>

#include "kernel/base/cycles.hpp"
#include "kernel/base/files/scratch.hpp"

namespace faster::recording {

/// Whether a dump's unit of time is a nanosecond: if a cycle is a whole number of them. Otherwise a picosecond.
bool counts_in_ns(double clock_mhz);
/// In that unit.
double ticks_per_cycle(double clock_mhz);
/// Bits of a signal that shows numbers up to the largest.
inline unsigned bits_for(std::uint64_t largest) {
    return largest == 0 ? 1 : 64U - static_cast<unsigned>(__builtin_clzll(largest));
}

/// Writes a value change dump (IEEE 1364-2005, clause 18). Values are set cycle by cycle; of several in one cycle the
/// last counts, and what does not change is not written. Signals belong to domains, each with a window of cycles of its
/// own, outside of which they read as unknown.
class VcdFile {
  public:
    using Signal = std::size_t;

    /// The file appears when it is finished, not before; a device or pipe is written to at once. Errors: InputError if
    /// it cannot be written.
    VcdFile(std::filesystem::path const& file, double clock_mhz);

    void open_scope(std::string const& name);
    void close_scope();
    Signal add(std::string const& name, unsigned bits, std::size_t domain);
    /// Ends the declarations. `windows`: first and last cycle of each domain.
    void begin(std::vector<std::pair<Cycles, Cycles>> windows);

    /// Moves on to a cycle; what was scheduled up to it happens.
    void advance(Cycles cycle);
    void set(Signal signal, std::int64_t value);
    /// As set(), later.
    void schedule(Cycles cycle, Signal signal, std::int64_t value);
    /// In this cycle or a later one.
    void set_at(Cycles cycle, Signal signal, std::int64_t value) {
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
    /// Writes the rest and closes the file.
    void finish();

  private:
    struct Variable {
        std::uint64_t value = 0;
        std::uint64_t written = 0;
        std::uint32_t domain = 0;
        std::uint8_t bits = 1;
        bool was_known = false;  ///< what was written was a value
        bool is_written = false;
        bool is_dirty = false;
        std::array<char, 8> id{};  ///< ends with a zero
    };
    struct Later {
        Cycles cycle;
        std::uint64_t order;  ///< of scheduling: first come, first served
        Signal signal;
        std::int64_t value;
        bool operator>(Later const& other) const {
            return cycle != other.cycle ? cycle > other.cycle : order > other.order;
        }
    };
    static std::array<char, 8> id_of(std::size_t number);
    void flush_cycle();
    void touch(Signal signal);
    void touch_domain(std::size_t domain);
    void put_value(Variable const& variable, bool known);
    void put_text(std::string const& text);
    void write_out();
    Cycles next_stop(Cycles cycle) const;
    void cross_border();
    bool is_in_window(std::size_t domain) const {
        return cycle_ >= windows_[domain].first && cycle_ <= windows_[domain].second;
    }

    struct Closer {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    [[noreturn]] void fail(std::string const& why) const;

    std::filesystem::path name_;
    std::optional<io::Scratch> scratch_;  ///< until it is finished
    std::unique_ptr<std::FILE, Closer> file_;
    std::vector<char> buffer_;
    std::size_t fill_ = 0;
    double ticks_per_cycle_;
    std::vector<Variable> variables_;
    std::vector<Signal> dirty_;
    std::vector<std::pair<Cycles, Cycles>> windows_;
    Cycles first_ = 0;
    Cycles last_ = 0;
    // Nearly all is scheduled for one of the next few cycles: a ring of them, and a queue for what is further away.
    static constexpr std::size_t ring_size = 8;
    struct Change {
        Signal signal;
        std::int64_t value;
    };
    std::array<std::vector<Change>, ring_size> ring_;
    std::size_t in_ring_ = 0;
    std::priority_queue<Later, std::vector<Later>, std::greater<>> later_;
    std::uint64_t scheduled_ = 0;
    Cycles next_border_ = 0;
    Cycles cycle_ = 0;
};

}  // namespace faster::recording
