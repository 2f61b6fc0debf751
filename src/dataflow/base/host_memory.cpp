#include "dataflow/base/host_memory.hpp"

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>
#include <sys/resource.h>
#include <unistd.h>

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
    if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY)
        return available_on_host();
    std::uint64_t const most = limit.rlim_cur;
    return std::min(available_on_host(), most - std::min(most, address_bytes()));
}

std::uint64_t address_bytes() {
    std::uint64_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

}  // namespace dataflow
