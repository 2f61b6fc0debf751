#include "dataflow/run/config/run_config.hpp"

#include "dataflow/run/config/design.hpp"

namespace dataflow {

RunConfig::RunConfig() : design_(design().default_config()) {}

}  // namespace dataflow
