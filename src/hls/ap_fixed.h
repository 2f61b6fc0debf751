#pragma once
// ap_fixed and ap_ufixed by the tools' names: SystemC's fixed-point numbers, whose quantization and overflow modes are
// those of the tools. Results of operations are exact (sc_fxval), and are cut where they are assigned; a quotient of up
// to 64 bits is the tools', a wider one SystemC's. range() gives SystemC's bits. They are printed as a double is.
#include <algorithm>
#include <cstdint>
#include <ostream>
#include <systemc>
#include <sysc/datatypes/fx/fx.h>
#include <type_traits>

#include "ap_int.h"

using ap_q_mode = sc_dt::sc_q_mode;  // NOLINT
using ap_o_mode = sc_dt::sc_o_mode;  // NOLINT
// NOLINTBEGIN(readability-identifier-naming): as the tools have them
constexpr ap_q_mode AP_RND = sc_dt::SC_RND;
constexpr ap_q_mode AP_RND_ZERO = sc_dt::SC_RND_ZERO;
constexpr ap_q_mode AP_RND_MIN_INF = sc_dt::SC_RND_MIN_INF;
constexpr ap_q_mode AP_RND_INF = sc_dt::SC_RND_INF;
constexpr ap_q_mode AP_RND_CONV = sc_dt::SC_RND_CONV;
constexpr ap_q_mode AP_TRN = sc_dt::SC_TRN;
constexpr ap_q_mode AP_TRN_ZERO = sc_dt::SC_TRN_ZERO;
constexpr ap_o_mode AP_SAT = sc_dt::SC_SAT;
constexpr ap_o_mode AP_SAT_ZERO = sc_dt::SC_SAT_ZERO;
constexpr ap_o_mode AP_SAT_SYM = sc_dt::SC_SAT_SYM;
constexpr ap_o_mode AP_WRAP = sc_dt::SC_WRAP;

namespace faster_ap {

template <class Base, int bits, int integer_bits> class Fixed : public Base {
  public:
    static constexpr int width = bits, iwidth = integer_bits;

    Fixed() = default;
    /// SystemC has some of these for explicit use only.
    template <class From, std::enable_if_t<std::is_constructible_v<Base, From const&>, int> = 0>
    Fixed(From const& from) : Base(from) {}  // NOLINT(google-explicit-constructor)
    template <class From, std::enable_if_t<std::is_constructible_v<Base, From const&>, int> = 0>
    Fixed& operator=(From const& from) {
        Base::operator=(Base(from));
        return *this;
    }
    template <class Other> Fixed& operator/=(Other const& other) { return *this = *this / other; }
    int length() const { return this->wl(); }
};

/// What decides about a quotient: a side's bits, of how many of which are a fraction, as a number. First, of an
/// integer.
template <class Any> struct Divided {
    static constexpr bool is_fixed = false, is_known = Side<Any>::is_number, is_signed = Side<Any>::is_signed;
    static constexpr int width = Side<Any>::bits + (is_signed ? 1 : 0), fraction = 0;
    static Wide mantissa(Any const& number) { return wide(number); }
};
template <class Base, int bits, int integer_bits> struct Divided<Fixed<Base, bits, integer_bits>> {
    static constexpr bool is_fixed = true, is_known = bits <= 64, is_signed = std::is_base_of_v<sc_dt::sc_fix, Base>;
    static constexpr int width = bits, fraction = bits - integer_bits;
    static Wide mantissa(Base const& number) {
        std::uint64_t const all = number.range().to_uint64() << (64 - bits);
        if constexpr (is_signed)
            return static_cast<std::int64_t>(all) >> (64 - bits);
        else
            return all >> (64 - bits);
    }
};

/// As many bits of fraction as the dividend has, and those that the divisor lacks.
template <class A, class B> struct Quotient {
    using Of = Divided<A>;
    using By = Divided<B>;
    static constexpr int sign = By::is_signed ? 1 : 0;
    static constexpr int width = sign + Of::width + std::max(By::fraction, 0);
    static constexpr int integer = sign + Of::width - Of::fraction + By::fraction;
    static constexpr bool is_known = Of::is_known && By::is_known && (Of::is_fixed || By::is_fixed) && width <= 64;
    using Base = std::conditional_t<Of::is_signed || By::is_signed, sc_dt::sc_fixed<width, integer>,
                                    sc_dt::sc_ufixed<width, integer>>;
    using Type = Fixed<Base, width, integer>;
};

template <class A, class B, std::enable_if_t<Quotient<A, B>::is_known, int> = 0>
typename Quotient<A, B>::Type operator/(A const& a, B const& b) {
    using Of = Quotient<A, B>;
    Wide const dividend = Of::Of::mantissa(a) * (Wide{1} << std::max(Of::By::fraction, 0));
    typename Of::Type quotient;
    quotient.range() = static_cast<std::int64_t>(dividend / Of::By::mantissa(b));
    return quotient;
}

}  // namespace faster_ap

template <int bits, int integer_bits, ap_q_mode quantization = AP_TRN, ap_o_mode overflow = AP_WRAP,
          int saturated_bits = 0>
using ap_fixed = faster_ap::Fixed<sc_dt::sc_fixed<bits, integer_bits, quantization, overflow, saturated_bits>, bits,
                                  integer_bits>;
template <int bits, int integer_bits, ap_q_mode quantization = AP_TRN, ap_o_mode overflow = AP_WRAP,
          int saturated_bits = 0>
using ap_ufixed = faster_ap::Fixed<sc_dt::sc_ufixed<bits, integer_bits, quantization, overflow, saturated_bits>, bits,
                                   integer_bits>;
// NOLINTEND(readability-identifier-naming)

template <class Base, int bits, int integer_bits>
std::ostream& operator<<(std::ostream& out, faster_ap::Fixed<Base, bits, integer_bits> const& number) {
    return out << number.to_double();
}
