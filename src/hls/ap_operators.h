#pragma once
// Operators of ap_int and ap_uint up to 64 bits that give the tools' values where one side has a sign and the other has
// none. SystemC's make a plain 64-bit number of each side first: -5 < 100U is false then, and 100U - 200U above 0. And
// those above 64 bits in which SystemC's know no width, or are not there.
#include <algorithm>
#include <cstdint>
#include <limits>
#include <systemc>
#include <type_traits>

namespace faster_ap {

__extension__ using Wide = __int128;  // holds all of both sides

/// Of a number: the bits of its magnitude, and whether it has a sign.
template <class Any> struct Side {
    static constexpr bool is_ap = false, is_number = std::is_integral_v<Any>, is_signed = std::is_signed_v<Any>;
    static constexpr int bits = std::numeric_limits<Any>::digits;
};
template <int width> struct Side<sc_dt::sc_int<width>> {
    static constexpr bool is_ap = true, is_number = true, is_signed = true;
    static constexpr int bits = width - 1;
};
template <int width> struct Side<sc_dt::sc_uint<width>> {
    static constexpr bool is_ap = true, is_number = true, is_signed = false;
    static constexpr int bits = width;
};

template <class A, class B>
using IfSides = std::enable_if_t<Side<A>::is_number && Side<B>::is_number && (Side<A>::is_ap || Side<B>::is_ap), int>;

template <class A> Wide wide(A const& a) {
    if constexpr (Side<A>::is_ap)
        return a.value();
    else
        return a;
}

/// What a result of so many bits is: a plain number with a sign, but where that does not hold one without.
template <class A, class B, int bits>
using Result = std::conditional_t<(bits > 63 && !Side<A>::is_signed && !Side<B>::is_signed), std::uint64_t, std::int64_t>;
template <class A, class B> constexpr int most_bits = std::max(Side<A>::bits, Side<B>::bits);

/// By less than 0 to the other side, as the tools do it.
inline std::uint64_t shifted_left(std::uint64_t value, Wide by) { return by > 63 ? 0 : value << static_cast<int>(by); }
template <class Value> Value shifted_right(Value value, Wide by) {
    if (by > 63)
        return value < 0 ? static_cast<Value>(-1) : Value{0};
    return static_cast<Value>(value >> static_cast<int>(by));
}
template <class A> A shifted(A const& a, Wide left) {
    if (left < 0)
        return A(shifted_right(a.value(), -left));
    auto const bits = shifted_left(static_cast<std::uint64_t>(a.value()), left);
    return A(static_cast<decltype(a.value())>(bits));
}

/// A number above 64 bits.
template <class Any> struct Long {
    static constexpr bool is_it = false;
};
template <int width> struct Long<sc_dt::sc_bigint<width>> {
    static constexpr bool is_it = true;
    static constexpr int bits = width;
    using Base = sc_dt::sc_signed;
};
template <int width> struct Long<sc_dt::sc_biguint<width>> {
    static constexpr bool is_it = true;
    static constexpr int bits = width;
    using Base = sc_dt::sc_unsigned;
};
template <class A, class B>
using IfLongBy = std::enable_if_t<Long<A>::is_it && Side<B>::is_number, int>;
template <class A, class B>
using IfShortAndLong = std::enable_if_t<Side<A>::is_ap && Long<B>::is_it, int>;

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

#define FASTER_AP_OPERATOR(op, result_bits)                                                                 \
    template <class A, class B, faster_ap::IfSides<A, B> = 0>                                               \
    faster_ap::Result<A, B, result_bits> operator op(A const& a, B const& b) {                              \
        return static_cast<faster_ap::Result<A, B, result_bits>>(faster_ap::wide(a) op faster_ap::wide(b)); \
    }
FASTER_AP_OPERATOR(+, (faster_ap::most_bits<A, B> + 1))
FASTER_AP_OPERATOR(-, 0)  // below 0 for two without a sign, too
FASTER_AP_OPERATOR(*, (faster_ap::Side<A>::bits + faster_ap::Side<B>::bits))
FASTER_AP_OPERATOR(/, faster_ap::Side<A>::bits)
FASTER_AP_OPERATOR(%, (faster_ap::most_bits<A, B>))
FASTER_AP_OPERATOR(&, (faster_ap::most_bits<A, B>))
FASTER_AP_OPERATOR(|, (faster_ap::most_bits<A, B>))
FASTER_AP_OPERATOR(^, (faster_ap::most_bits<A, B>))
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
    return A(static_cast<decltype(a.value())>(~a.value()));
}
template <class A, faster_ap::IfSides<A, A> = 0> std::int64_t operator-(A const& a) {
    return static_cast<std::int64_t>(-faster_ap::wide(a));
}

/// The same of long numbers.
template <class A, class B, faster_ap::IfLongBy<A, B> = 0> A operator<<(A const& a, B const& by) {
    return faster_ap::long_shifted(a, faster_ap::wide(by));
}
template <class A, class B, faster_ap::IfLongBy<A, B> = 0> A operator>>(A const& a, B const& by) {
    return faster_ap::long_shifted(a, -faster_ap::wide(by));
}
template <class A, class B, faster_ap::IfLongBy<A, B> = 0> A& operator<<=(A& a, B const& by) { return a = a << by; }
template <class A, class B, faster_ap::IfLongBy<A, B> = 0> A& operator>>=(A& a, B const& by) { return a = a >> by; }
template <int width> sc_biguint<width> operator~(sc_biguint<width> const& a) {
    sc_biguint<width> inverted;
    inverted = ~static_cast<sc_unsigned const&>(a);
    return inverted;
}
template <class A, std::enable_if_t<faster_ap::Long<A>::is_it, int> = 0> bool operator!(A const& a) { return a == 0; }

// NOLINTBEGIN(bugprone-macro-parentheses): operators
#define FASTER_AP_ASSIGNMENT(op)                                     \
    template <class A, class B, faster_ap::IfShortAndLong<A, B> = 0> \
    A& operator op##=(A& a, B const& b) {                            \
        return a = a op b;                                           \
    }
FASTER_AP_ASSIGNMENT(+)
FASTER_AP_ASSIGNMENT(-)
FASTER_AP_ASSIGNMENT(*)
FASTER_AP_ASSIGNMENT(/)
FASTER_AP_ASSIGNMENT(%)
FASTER_AP_ASSIGNMENT(&)
FASTER_AP_ASSIGNMENT(|)
FASTER_AP_ASSIGNMENT(^)
#undef FASTER_AP_ASSIGNMENT
// NOLINTEND(bugprone-macro-parentheses)

}  // namespace sc_dt
