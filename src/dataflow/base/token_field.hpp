#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>

namespace dataflow {

/// One number of a token, as recordings show it.
struct TokenField {
    char const* name;
    unsigned bits;
    bool is_signed = false;
    static constexpr int only_lane = -1;
    int lane = only_lane;  ///< of a token of several values: which of them
    /// What its values 0, 1, ... mean, a word each, separated by spaces; null: it is a number.
    char const* values = nullptr;
};

/// "depth"; of a token of several values "depth0", "depth1", ...
inline std::string label(TokenField const& field) {
    return field.lane == TokenField::only_lane ? field.name : field.name + std::to_string(field.lane);
}

/// The fields of a token type: `layout`, and a token's values in that order, sign-extended. As it stands here, for
/// plain numbers; a design specializes it for its own token types.
template <class Token> struct TokenFields {
    static_assert(std::is_integral_v<Token>, "specialize TokenFields for this token type");

    static constexpr bool is_signed = std::is_signed_v<Token>;
    static constexpr unsigned bits = static_cast<unsigned>(std::numeric_limits<Token>::digits) + (is_signed ? 1U : 0U);
    static constexpr std::array<TokenField, 1> layout{{{"value", bits, is_signed}}};
    static std::array<std::int64_t, 1> values(Token token) { return {static_cast<std::int64_t>(token)}; }
};

}  // namespace dataflow
