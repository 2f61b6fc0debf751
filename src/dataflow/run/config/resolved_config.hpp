#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "dataflow/run/config/key_value.hpp"
#include "dataflow/run/config/run_config.hpp"

namespace dataflow {

/// One key of a resolved configuration, for the report of a run.
struct ResolvedKey {
    std::string key;
    KeyValue value;
    bool is_default = true;  ///< the value equals the default, whether it was written out or not
};

/// Which keys: those that a run looks at, or all.
enum class KeyScope { of_runs, all };

/// Every key with its value, in the order of all_keys().
std::vector<ResolvedKey> resolved_keys(RunConfig const& config, KeyScope scope = KeyScope::of_runs);

/// Those of `keys`, in their order, as a configuration file.
std::string to_yaml(std::vector<ResolvedKey> const& keys);

/// What a configuration file of a configuration has to say: keys that differ from the defaults and are of parts that
/// are there. It does not name a preset, which might say something else again.
std::string exported_yaml(RunConfig const& config);

/// A configuration as a file that loads to an equal configuration; values that differ from the default say so in
/// a comment. Relative paths stay relative to the current folder, so it belongs there.
std::string to_yaml(RunConfig const& config);

/// "fnv1a64:" and 16 hexadecimal digits: the FNV-1a hash (64 bits, offset 14695981039346656037, prime 1099511628211) of
/// the lines "KEY=VALUE\n" of all keys in the order of configs/README.md, values as JSON. What decides no figure is
/// left out: it changes neither function nor time.
std::string configuration_hash(std::vector<ResolvedKey> const& keys);

/// "fnv1a64:" and the 16 digits of any text.
std::string hash_of(std::string_view text);

}  // namespace dataflow
