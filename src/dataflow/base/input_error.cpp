#include "kernel/base/input_error.hpp"

#include "kernel/base/printable.hpp"

namespace faster {

InputError::InputError(std::string const& message) : std::runtime_error(message_line(message)) {}

}  // namespace faster
