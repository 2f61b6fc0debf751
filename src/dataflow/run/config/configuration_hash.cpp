#include "dataflow/run/config/configuration_hash.hpp"

#include <fmt/format.h>

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

std::string hash_of(std::string_view text) {
    Fnv1a hash;
    hash.add(text);
    return fmt::format("fnv1a64:{:016x}", hash.value());
}

}  // namespace dataflow
