#include "dataflow/base/confinement.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include "dataflow/base/host_memory.hpp"

namespace dataflow::processes {

namespace {

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
    lower(RLIMIT_AS, address_bytes() + more_memory_bytes);
    fall_silent();
}

}  // namespace dataflow::processes
