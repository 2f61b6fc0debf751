#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace faster::test {

/// A value change dump, read by rules of its own: every signal's values, from which time on.
struct Vcd {
    struct Value {
        std::uint64_t cycle = 0;
        bool known = false;
        std::uint64_t bits = 0;
        friend bool operator==(Value const& a, Value const& b) {
            return a.cycle == b.cycle && a.known == b.known && (!a.known || a.bits == b.bits);
        }
    };
    std::map<std::string, std::vector<Value>> signals;  ///< by path without "accelerator."
    std::string timescale;

    /// Cycles in which a signal has a value.
    std::uint64_t duration(std::string const& signal, std::uint64_t bits) const;
    std::uint64_t largest(std::string const& signal) const;
    /// The values of a signal in the cycles in which another is 1.
    std::vector<Value> sampled(std::string const& signal, std::string const& enable) const;
    /// A signal's known values within [from, to], the one at `from` first.
    std::vector<Value> within(std::string const& signal, std::uint64_t from, std::uint64_t to) const;
    Value at(std::string const& signal, std::uint64_t cycle) const;
};

Vcd read_vcd(std::filesystem::path const& file, std::uint64_t ticks_per_cycle);
/// Reads an FST, by GTKWave's code.
Vcd read_fst(std::filesystem::path const& file, std::uint64_t ticks_per_cycle);

}  // namespace faster::test
