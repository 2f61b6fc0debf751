#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <type_traits>

/// Wires of a token whose type cannot say them: `template <> constexpr unsigned faster_bits<Pixel> = 17;` beside it.
template <class Token> constexpr unsigned faster_bits = 0;

namespace dataflow::untimed {

/// How wide a token is, and the number that waveforms show of it: of integers their value, of fixed-point numbers their
/// bits, of anything else its first eight bytes. The wires of a struct are faster_bits<STRUCT>, a constant `bits` in
/// it, or all of its memory if it has no padding. Of any other the width is 0: not known.
template <class Token> struct TokenTraits {
    static unsigned bits() {
        if constexpr (faster_bits<Token> != 0)
            return faster_bits<Token>;
        else if constexpr (std::is_same_v<Token, bool>)
            return 1;
        else if constexpr (decltype(has_word_length<Token>(0))::value)
            return static_cast<unsigned>(Token().wl());
        else if constexpr (decltype(has_length<Token>(0))::value)
            return static_cast<unsigned>(Token().length());
        else if constexpr (decltype(says_bits<Token>(0))::value)
            return Token::bits;
        else if constexpr (std::is_arithmetic_v<Token> || std::has_unique_object_representations_v<Token>)
            return 8 * sizeof(Token);
        else if constexpr (std::is_trivially_copy_constructible_v<Token> && std::is_trivially_destructible_v<Token>)
            return has_padding() ? 0 : 8 * sizeof(Token);
        else
            return 0;
    }
    static bool is_signed() {
        if constexpr (std::is_integral_v<Token>)
            return std::is_signed_v<Token>;
        else if constexpr (decltype(has_int64<Token>(0))::value && std::is_constructible_v<Token, int>)
            return Token(-1) < Token(0);
        else
            return false;
    }
    static std::int64_t shown(Token const& token) {
        if constexpr (std::is_integral_v<Token> || std::is_enum_v<Token>) {
            return static_cast<std::int64_t>(token);
        } else if constexpr (decltype(has_word_length<Token>(0))::value) {
            return static_cast<std::int64_t>(std::ldexp(token.to_double(), token.wl() - token.iwl()));
        } else if constexpr (decltype(has_int64<Token>(0))::value) {
            return static_cast<std::int64_t>(token.to_int64());
        } else {
            std::int64_t value = 0;
            if constexpr (std::is_trivially_copyable_v<Token>)
                std::memcpy(&value, &token, std::min(sizeof value, sizeof token));
            return value;
        }
    }

  private:
    /// A number may have several representations, as a float's 0 has.
    static bool has_padding() {
#if defined(__has_builtin) && __has_builtin(__builtin_clear_padding)
        Token token{};
        auto* const first = reinterpret_cast<unsigned char*>(&token);
        std::fill(first, first + sizeof token, std::uint8_t{0xFF});
        __builtin_clear_padding(&token);
        return std::any_of(first, first + sizeof token, [](unsigned char byte) { return byte != 0xFF; });
#else
        return true;
#endif
    }
    template <class Any> static auto has_word_length(int) -> decltype(Any().wl(), std::true_type());
    template <class Any> static std::false_type has_word_length(...);
    template <class Any> static auto says_bits(int) -> decltype(std::bool_constant<(Any::bits > 0)>());
    template <class Any> static std::false_type says_bits(...);
    template <class Any> static auto has_length(int) -> decltype(Any().length(), Any().to_int64(), std::true_type());
    template <class Any> static std::false_type has_length(...);
    template <class Any> static auto has_int64(int) -> decltype(Any().to_int64(), std::true_type());
    template <class Any> static std::false_type has_int64(...);
};

}  // namespace dataflow::untimed
