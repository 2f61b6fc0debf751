#include "dataflow/run/config/configuration_hash.hpp"

#include "dataflow/base/fnv1a.hpp"
#include "dataflow/run/config/keys.hpp"

namespace dataflow {

std::string configuration_hash(std::vector<ResolvedKey> const& keys) {
    std::string lines;
    for (ResolvedKey const& key : keys)
        if (decides_figures(key.key))
            lines += key.key + "=" + json_text(key.value) + "\n";
    return hash_of(lines);
}

std::string hash_of(std::string_view text) { return "fnv1a64:" + fnv1a_digits(text); }

}  // namespace dataflow
