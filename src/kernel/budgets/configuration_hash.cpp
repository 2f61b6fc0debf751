#include "kernel/budgets/configuration_hash.hpp"

#include <fmt/format.h>
#include <variant>

#include "kernel/base/fnv1a.hpp"
#include "kernel/config/keys.hpp"
#include "kernel/config/plain_value.hpp"

namespace faster::budgets {

std::string configuration_hash(std::vector<ResolvedKey> const& keys) {
    Fnv1a hash;
    for (ResolvedKey const& key : keys) {
        if (!decides_figures(key.key))
            continue;
        hash.add(key.key + "=" + json_text(key.value) + "\n");
    }
    return fmt::format("fnv1a64:{:016x}", hash.value());
}

std::vector<Setting> accelerator_settings(std::vector<ResolvedKey> const& keys) {
    std::vector<Setting> settings;
    for (ResolvedKey const& key : keys)
        if (!key.is_default && key.key.rfind("accelerator.", 0) == 0)
            settings.push_back({key.key, plain_text(key.value)});
    return settings;
}

}  // namespace faster::budgets
