#include "budgets/configuration_hash.hpp"

#include <cstdint>
#include <fmt/format.h>
#include <variant>

namespace faster::budgets {

namespace {

constexpr std::uint64_t offset_basis = 14695981039346656037U;
constexpr std::uint64_t prime = 1099511628211U;

std::string plain_text_of(KeyValue const& value) {
    auto const* const word = std::get_if<std::string>(&value);
    return word != nullptr ? *word : json_text(value);
}

}  // namespace

std::string configuration_hash(std::vector<ResolvedKey> const& keys) {
    std::uint64_t hash = offset_basis;
    for (ResolvedKey const& key : keys) {
        if (key.key == "simulation.engine")
            continue;
        for (char const letter : key.key + "=" + json_text(key.value) + "\n")
            hash = (hash ^ static_cast<unsigned char>(letter)) * prime;
    }
    return fmt::format("fnv1a64:{:016x}", hash);
}

std::vector<Setting> accelerator_settings(std::vector<ResolvedKey> const& keys) {
    std::vector<Setting> settings;
    for (ResolvedKey const& key : keys)
        if (!key.is_default && key.key.rfind("accelerator.", 0) == 0)
            settings.push_back({key.key, plain_text_of(key.value)});
    return settings;
}

}  // namespace faster::budgets
