#pragma once
#include <stdexcept>
#include <string>

namespace dataflow {

/// Something the user handed us (configuration, image, trace, flag) is unusable. `what()` is one line that names
/// the file, line or key, what was found and what was expected. The binary exits with code 2 on it
/// (docs/formats.md#exit-codes). Here, where every message passes, what came from outside is made fit to be printed:
/// see message_line().
class InputError : public std::runtime_error {
  public:
    explicit InputError(std::string const& message);
};

/// The input may be all right, but the host cannot do what is needed now: no room, no descriptors, no threads, a disk
/// that fails. The same may work later.
class HostError : public InputError {
  public:
    using InputError::InputError;
};

}  // namespace dataflow
