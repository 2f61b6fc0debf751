#include "dataflow/base/input_error.hpp"

#include "dataflow/base/printable.hpp"

namespace dataflow {

InputError::InputError(std::string const& message) : std::runtime_error(message_line(message)) {}

}  // namespace dataflow
