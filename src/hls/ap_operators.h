#pragma once
// Operators of ap_int and ap_uint up to 64 bits that give numbers as wide as the tools', and their values where one side
// has a sign and the other has none. SystemC's make a plain 64-bit number of each side first: -5 < 100U is false then,
// and 100U - 200U above 0. Comparisons are those of the numbers, as hardware makes them; the tools' C simulation follows
// C where a side has 32 bits and more. And operators above 64 bits in which SystemC's know no width, or are not there.
#include <algorithm>
#include <cstdint>
#include <limits>
#include <systemc>
#include <type_traits>

// NOLINTBEGIN(readability-identifier-naming): as the tools have them
template <int bits> class ap_int;
template <int bits> class ap_uint;
// NOLINTEND(readability-identifier-naming)

namespace faster_ap {

__extension__ using Wide = __int128;  // holds all of both sides

/// Of a number of up to 64 bits: the bits of its magnitude, and whether it has a sign.
template <bool is_number_of_tools, int magnitude, bool has_sign> struct ApSide {
    static constexpr bool is_ap = is_number_of_tools, is_number = is_ap, is_signed = has_sign;
    static constexpr int bits = magnitude;
};
template <class Any> struct Side {
    static constexpr bool is_ap = false, is_number = std::is_integral_v<Any>, is_signed = std::is_signed_v<Any>;
    static constexpr int bits = std::numeric_limits<Any>::digits;
};
template <int width> struct Side<sc_dt::sc_int<width>> : ApSide<true, width - 1, true> {};
template <int width> struct Side<sc_dt::sc_uint<width>> : ApSide<true, width, false> {};
template <int width> struct Side<ap_int<width>> : ApSide<(width <= 64), width - 1, true> {};
template <int width> struct Side<ap_uint<width>> : ApSide<(width <= 64), width, false> {};

template <class A, class B>
using IfSides = std::enable_if_t<Side<A>::is_number && Side<B>::is_number && (Side<A>::is_ap || Side<B>::is_ap), int>;

template <class A> Wide wide(A const& a) {
    if constexpr (Side<A>::is_ap)
        return a.value();
    else
        return a;
}

/// A result with so many bits of magnitude; beyond 64 bits the lower ones.
template <bool is_signed, int bits>
using Result = std::conditional_t<is_signed, ap_int<std::min(bits + 1, 64)>, ap_uint<std::min(bits, 64)>>;
template <class A, class B> constexpr bool any_sign = Side<A>::is_signed || Side<B>::is_signed;
template <class A, class B> constexpr bool both_signs = Side<A>::is_signed && Side<B>::is_signed;
template <class A, class B> constexpr int most_bits = std::max(Side<A>::bits, Side<B>::bits);
template <class To> To cut(Wide value) {
    return To(static_cast<std::conditional_t<Side<To>::is_signed, std::int64_t, std::uint64_t>>(value));
}

/// By less than 0 to the other side, as the tools do it.
inline std::uint64_t shifted_left(std::uint64_t value, Wide by) { return by > 63 ? 0 : value << static_cast<int>(by); }
template <class Value> Value shifted_right(Value value, Wide by) {
    if (by > 63)
        return value < 0 ? static_cast<Value>(-1) : Value{0};
    return static_cast<Value>(value >> static_cast<int>(by));
}
template <class A> A shifted(A const& a, Wide left) {
    if (left < 0)
        return cut<A>(shifted_right(a.value(), -left));
    return cut<A>(shifted_left(static_cast<std::uint64_t>(a.value()), left));
}

/// A number above 64 bits.
template <class Of, int width> struct LongOf {
    static constexpr bool is_it = width > 64;
    static constexpr int bits = width;
    using Base = Of;
};
template <class Any> struct Long : LongOf<Any, 0> {};
template <int width> struct Long<sc_dt::sc_bigint<width>> : LongOf<sc_dt::sc_signed, width> {};
template <int width> struct Long<sc_dt::sc_biguint<width>> : LongOf<sc_dt::sc_unsigned, width> {};
template <int width> struct Long<ap_int<width>> : LongOf<sc_dt::sc_signed, width> {};
template <int width> struct Long<ap_uint<width>> : LongOf<sc_dt::sc_unsigned, width> {};
template <class A, class B>
using IfLongBy = std::enable_if_t<Long<A>::is_it && Side<B>::is_number, int>;
template <class A, class B>
using IfAssigned = std::enable_if_t<(Side<A>::is_ap || Long<A>::is_it) && (Side<B>::is_number || Long<B>::is_it), int>;

template <class A> A long_shifted(A const& a, Wide left) {
    using Base = typename Long<A>::Base;
    int const by = static_cast<int>(std::min<Wide>(left < 0 ? -left : left, Long<A>::bits));
    A result;
    if (left < 0)
        result = static_cast<Base const&>(a) >> by;
    else
        result = static_cast<Base const&>(a) << by;
    return result;
}

}  // namespace faster_ap

namespace sc_dt {  // where the compiler looks for operators of these types

// NOLINTBEGIN(bugprone-macro-parentheses): operators, and arguments of templates
#define FASTER_AP_COMPARISON(op)                              \
    template <class A, class B, faster_ap::IfSides<A, B> = 0> \
    bool operator op(A const& a, B const& b) {                \
        return faster_ap::wide(a) op faster_ap::wide(b);      \
    }
FASTER_AP_COMPARISON(==)
FASTER_AP_COMPARISON(!=)
FASTER_AP_COMPARISON(<)
FASTER_AP_COMPARISON(<=)
FASTER_AP_COMPARISON(>)
FASTER_AP_COMPARISON(>=)
#undef FASTER_AP_COMPARISON

#define FASTER_AP_OPERATOR(op, is_signed, bits)                                                              \
    template <class A, class B, faster_ap::IfSides<A, B> = 0>                                                \
    faster_ap::Result<is_signed, bits> operator op(A const& a, B const& b) {                                 \
        return faster_ap::cut<faster_ap::Result<is_signed, bits>>(faster_ap::wide(a) op faster_ap::wide(b)); \
    }
FASTER_AP_OPERATOR(+, (faster_ap::any_sign<A, B>), (faster_ap::most_bits<A, B> + 1))
FASTER_AP_OPERATOR(-, true, (faster_ap::most_bits<A, B> + faster_ap::any_sign<A, B>))
FASTER_AP_OPERATOR(*, (faster_ap::any_sign<A, B>),
                   (faster_ap::Side<A>::bits + faster_ap::Side<B>::bits + faster_ap::both_signs<A, B>))
FASTER_AP_OPERATOR(/, (faster_ap::any_sign<A, B>), (faster_ap::Side<A>::bits + faster_ap::both_signs<A, B>))
FASTER_AP_OPERATOR(%, (faster_ap::Side<A>::is_signed), (std::min(faster_ap::Side<A>::bits, faster_ap::Side<B>::bits)))
FASTER_AP_OPERATOR(&, (faster_ap::any_sign<A, B>), (faster_ap::most_bits<A, B>))
FASTER_AP_OPERATOR(|, (faster_ap::any_sign<A, B>), (faster_ap::most_bits<A, B>))
FASTER_AP_OPERATOR(^, (faster_ap::any_sign<A, B>), (faster_ap::most_bits<A, B>))
#undef FASTER_AP_OPERATOR
// NOLINTEND(bugprone-macro-parentheses)

/// As wide as the left side.
template <class A, class B, faster_ap::IfSides<A, B> = 0, std::enable_if_t<faster_ap::Side<A>::is_ap, int> = 0>
A operator<<(A const& a, B const& by) {
    return faster_ap::shifted(a, faster_ap::wide(by));
}
template <class A, class B, faster_ap::IfSides<A, B> = 0, std::enable_if_t<faster_ap::Side<A>::is_ap, int> = 0>
A operator>>(A const& a, B const& by) {
    return faster_ap::shifted(a, -faster_ap::wide(by));
}
template <class A, faster_ap::IfSides<A, A> = 0> A operator~(A const& a) {
    return faster_ap::cut<A>(~faster_ap::wide(a));
}
template <class A, faster_ap::IfSides<A, A> = 0> auto operator-(A const& a) {
    using Side = faster_ap::Side<A>;
    return faster_ap::cut<faster_ap::Result<true, Side::bits + Side::is_signed>>(-faster_ap::wide(a));
}

/// Long ones.
template <class A, class B, faster_ap::IfLongBy<A, B> = 0> A operator<<(A const& a, B const& by) {
    return faster_ap::long_shifted(a, faster_ap::wide(by));
}
template <class A, class B, faster_ap::IfLongBy<A, B> = 0> A operator>>(A const& a, B const& by) {
    return faster_ap::long_shifted(a, -faster_ap::wide(by));
}
template <int width> sc_biguint<width> operator~(sc_biguint<width> const& a) {
    sc_biguint<width> inverted;
    inverted = ~static_cast<sc_unsigned const&>(a);
    return inverted;
}
template <class A, std::enable_if_t<faster_ap::Long<A>::is_it, int> = 0> bool operator!(A const& a) { return a == 0; }

// NOLINTBEGIN(bugprone-macro-parentheses): operators
#define FASTER_AP_ASSIGNMENT(op)                                     \
    template <class A, class B, faster_ap::IfAssigned<A, B> = 0> \
    A& operator op##=(A& a, B const& b) {                        \
        return a = a op b;                                       \
    }
FASTER_AP_ASSIGNMENT(+)
FASTER_AP_ASSIGNMENT(-)
FASTER_AP_ASSIGNMENT(*)
FASTER_AP_ASSIGNMENT(/)
FASTER_AP_ASSIGNMENT(%)
FASTER_AP_ASSIGNMENT(&)
FASTER_AP_ASSIGNMENT(|)
FASTER_AP_ASSIGNMENT(^)
FASTER_AP_ASSIGNMENT(<<)
FASTER_AP_ASSIGNMENT(>>)
#undef FASTER_AP_ASSIGNMENT
// NOLINTEND(bugprone-macro-parentheses)

}  // namespace sc_dt
