#include "dataflow/base/host_memory.hpp"

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>
#include <sys/resource.h>

namespace dataflow {

namespace {

constexpr std::uint64_t unknown = std::numeric_limits<std::uint64_t>::max();

std::uint64_t available_on_host() {
    std::ifstream stream("/proc/meminfo");
    std::string name, unit;
    for (std::uint64_t kilobytes = 0; stream >> name >> kilobytes; std::getline(stream, unit))
        if (name == "MemAvailable:")
            return kilobytes << 10U;
    return unknown;
}

}  // namespace

std::uint64_t available_memory_bytes() {
    rlimit limit{};
    bool const is_limited = getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
    return std::min(available_on_host(), is_limited ? std::uint64_t{limit.rlim_cur} : unknown);
}

}  // namespace dataflow
