#include "kernel/config/key_faults.hpp"

#include "kernel/base/input_error.hpp"

namespace faster {

void throw_first(std::vector<std::string> const& messages) {
    if (messages.empty()) {
        return;
    }
    std::size_t const others = messages.size() - 1;
    throw InputError(messages.front() + (others == 0 ? "" : " (and " + std::to_string(others) + " more)"));
}

}  // namespace faster
