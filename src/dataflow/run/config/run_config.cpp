#include "kernel/config/run_config.hpp"

#include "kernel/config/design.hpp"

namespace faster {

RunConfig::RunConfig() : design_(design().default_config()) {}

}  // namespace faster
