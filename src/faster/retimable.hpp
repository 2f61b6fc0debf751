#pragma once
#include "faster/accelerator_config.hpp"
#include "kernel/config/key.hpp"

namespace faster {

/// Whether a key decides about time only, so that it may be changed without running the function again: one of
/// retiming_keys(), unless `config` makes it decide about more.
bool is_retimable(Key const& key, AcceleratorConfig const& config);

}  // namespace faster
