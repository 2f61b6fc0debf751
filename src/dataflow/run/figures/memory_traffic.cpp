#include "dataflow/run/figures/memory_traffic.hpp"

#include <algorithm>

namespace dataflow {

namespace {
double quotient(double part, double whole) { return whole > 0 ? part / whole : 0; }
}  // namespace

std::uint64_t MemoryTraffic::bytes() const {
    std::uint64_t sum = 0;
    for (MasterStatistics const& master : masters)
        sum += master.bytes;
    return sum;
}

double MemoryTraffic::gb_per_s(std::uint64_t moved, Cycles cycles) const {
    constexpr double per_picosecond = 1000;  // a byte per picosecond is so many GB/s
    return per_picosecond * quotient(static_cast<double>(moved), static_cast<double>(Picoseconds{cycles} * period_ps));
}

double MemoryTraffic::controller_utilisation(Cycles cycles) const {
    return quotient(static_cast<double>(controller_busy_ps), static_cast<double>(Picoseconds{cycles} * period_ps));
}

Cycles MemoryTraffic::memory_alone() const {
    auto alone = static_cast<Cycles>((controller_busy_ps + period_ps - 1) / period_ps);
    for (Cycles const beats : port_beats)
        alone = std::max(alone, beats);
    return alone;
}

}  // namespace dataflow
