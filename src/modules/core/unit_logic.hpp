#pragma once
#include <string>
#include <utility>
#include <vector>

#include "faster/config/synthesized_units.hpp"
#include "modules/core/counted_resources.hpp"

namespace faster {

/// What a unit of the twin takes, and its longest paths.
struct UnitLogic {
    ResourceParts parts;
    std::vector<UnitPath> paths;
};

inline UnitLogic& operator+=(UnitLogic& a, UnitLogic const& b) {
    a.parts.insert(a.parts.end(), b.parts.begin(), b.parts.end());
    a.paths.insert(a.paths.end(), b.paths.begin(), b.paths.end());
    return a;
}

template <class Number> UnitKey number_key(char const* name, Number value, int standard) {
    return {name, std::to_string(value), std::to_string(standard)};
}
inline UnitKey choice_key(char const* name, bool holds, char const* value) { return {name, holds ? value : "", ""}; }

/// Without its memories, which are counted for themselves.
inline UnitLogic synthesized_logic(char const* unit, std::vector<UnitKey> const& keys) {
    ResourcePart part = synthesized_units().unit(unit, keys);
    part.amount.ramb36 = 0;
    return {{std::move(part)}, synthesized_paths().paths(unit, differing_keys(keys))};
}

/// Longest paths of a unit with so many lanes, or with more where none has as many: a region and a second buffer change
/// no path.
inline std::vector<UnitPath> paths_with_lanes(char const* unit, int lanes) {
    if (lanes == 1)
        return synthesized_paths().paths(unit, {});
    return synthesized_paths().paths(unit, {{"lanes", lanes <= 5 ? "5" : "10"}});
}

}  // namespace faster
