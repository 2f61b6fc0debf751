#include "dataflow/base/confinement.hpp"

#include <fcntl.h>
#include <fstream>
#include <sys/resource.h>
#include <unistd.h>

namespace dataflow::processes {

namespace {

/// Of addresses, whether they are backed by memory or not, as RLIMIT_AS counts them.
std::uint64_t bytes_now() {
    std::uint64_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

void lower(__rlimit_resource resource, std::uint64_t most) {
    rlimit limit{};
    if (getrlimit(resource, &limit) != 0 || limit.rlim_cur <= most)
        return;
    limit.rlim_cur = most;
    setrlimit(resource, &limit);
}

void fall_silent() {
    int const nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (nowhere < 0)
        return;
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
}

}  // namespace

void confine_process(std::uint64_t more_memory_bytes) {
    lower(RLIMIT_CORE, 0);
    lower(RLIMIT_AS, bytes_now() + more_memory_bytes);
    fall_silent();
}

}  // namespace dataflow::processes
