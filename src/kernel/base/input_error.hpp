#pragma once
#include <stdexcept>

namespace faster {

/// Something the user handed us (configuration, mesh, image, trace, flag) is unusable. `what()` is one line that names
/// the file, line or key, what was found and what was expected. The binary exits with code 2 on it (SPEC section 4).
class InputError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace faster
