#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "dataflow/run/config/resolved_config.hpp"

namespace dataflow {

/// "fnv1a64:" and 16 hexadecimal digits: the FNV-1a hash (64 bits, offset 14695981039346656037, prime 1099511628211) of
/// the lines "KEY=VALUE\n" of all keys in the order of configs/README.md, values as JSON. What decides no figure is
/// left out: it changes neither function nor time.
std::string configuration_hash(std::vector<ResolvedKey> const& keys);

/// "fnv1a64:" and the 16 digits of any text.
std::string hash_of(std::string_view text);

}  // namespace dataflow
