#include "kernel/explore/keys_json.hpp"

#include "kernel/config/idle_keys.hpp"
#include "kernel/config/key_names.hpp"
#include "kernel/config/keys.hpp"
#include "kernel/config/plain_value.hpp"
#include "kernel/config/resolved_config.hpp"

namespace faster::explore {

namespace {

/// No bound is null: JSON has no infinity.
Json range_json(Key const& key) {
    if (key.kind == KeyKind::integer)
        return {{"min", key.integers.min}, {"max", key.integers.max}};
    if (key.kind == KeyKind::number)
        return {{"min", std::isfinite(key.numbers.min) ? Json(key.numbers.min) : Json()},
                {"max", std::isfinite(key.numbers.max) ? Json(key.numbers.max) : Json()}};
    return {{"choices", key.choices}};
}

char const* kind_of(Key const& key) {
    return key.kind == KeyKind::integer ? "integer" : key.kind == KeyKind::number ? "number" : "choice";
}

}  // namespace

Json keys_json(RunConfig const& recorded) {
    RunConfig const defaults;
    Json rows = Json::array();
    for (Key const& key : retimable_keys(recorded)) {
        rows.push_back({{"key", key.name()},
                        {"kind", kind_of(key)},
                        {"value", plain_text(key.read(recorded))},
                        {"default", plain_text(key.read(defaults))},
                        {"unit", key.text.unit},
                        {"meaning", key.text.meaning},
                        {"source", key.text.source},
                        {"accepts", expectation(key)}});
        rows.back().update(range_json(key));
    }
    return rows;
}

std::string exported_yaml(RunConfig const& config) {
    IdleKeys const idle = idle_keys(config);
    std::vector<ResolvedKey> keys;
    for (ResolvedKey& key : resolved_keys(config))
        if (!key.is_default && key.key != architecture_key_name && idle.decider_of(key.key) == nullptr)
            keys.push_back(std::move(key));
    return to_yaml(keys);
}

}  // namespace faster::explore
