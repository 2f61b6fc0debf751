#include "dataflow/run/config/key_faults.hpp"

#include "dataflow/base/input_error.hpp"

namespace dataflow {

void throw_first(std::vector<std::string> const& messages) {
    if (messages.empty()) {
        return;
    }
    std::size_t const others = messages.size() - 1;
    throw InputError(messages.front() + (others == 0 ? "" : " (and " + std::to_string(others) + " more)"));
}

}  // namespace dataflow
