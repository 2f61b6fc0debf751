#include "kernel/budgets/accelerator_settings.hpp"

#include "kernel/config/plain_value.hpp"

namespace faster::budgets {

std::vector<Setting> accelerator_settings(std::vector<ResolvedKey> const& keys) {
    std::vector<Setting> settings;
    for (ResolvedKey const& key : keys)
        if (!key.is_default && key.key.rfind("accelerator.", 0) == 0)
            settings.push_back({key.key, plain_text(key.value)});
    return settings;
}

}  // namespace faster::budgets
