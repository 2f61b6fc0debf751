#include "kernel/report/html/configuration_data.hpp"

#include "kernel/config/plain_value.hpp"

namespace faster::report {

Json configuration_data(std::vector<ResolvedKey> const& keys) {
    Json rows = Json::array();
    for (ResolvedKey const& key : keys)
        rows.push_back({{"key", key.key}, {"value", plain_text(key.value)}, {"default", key.is_default}});
    return rows;
}

}  // namespace faster::report
