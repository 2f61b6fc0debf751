#pragma once
#include <chrono>

namespace dataflow {

using HostClock = std::chrono::steady_clock;

inline double seconds_since(HostClock::time_point start) {
    return std::chrono::duration<double>(HostClock::now() - start).count();
}

}  // namespace dataflow
