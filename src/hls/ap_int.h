#pragma once
// ap_int and ap_uint by the tools' names: SystemC's integers of any width, with the conversions, operators, methods and
// output of the tools. Not the same: a result of two integers of up to 64 bits has no more than 64 (a product of two
// ap_int<40> overflows), and one above 64 bits is SystemC's. docs/hls.md has more.
#include <cctype>
#include <cstdint>
#include <ios>
#include <ostream>
#include <string>
#include <systemc>
#include <sysc/datatypes/fx/fx.h>
#include <type_traits>

#include "ap_operators.h"

namespace faster_ap {

template <class From>
constexpr bool is_fixed = std::is_base_of_v<sc_dt::sc_fxnum, From> || std::is_same_v<sc_dt::sc_fxval, From>;
template <class To, class From>
using IfGiven = std::enable_if_t<is_fixed<From> || std::is_assignable_v<To&, From const&>, int>;

/// Digits of that radix, with or without its prefix, as SystemC reads a sign and a magnitude.
inline std::string as_magnitude(std::string digits, int radix) {
    std::string sign;
    if (digits.find_first_of("+-") == 0) {
        sign = digits[0] == '-' ? "-" : "";
        digits.erase(0, 1);
    }
    std::string const name = radix == 16 ? "x" : radix == 8 ? "o" : radix == 2 ? "b" : "d";
    if (digits.size() > 2 && digits[0] == '0' && std::tolower(static_cast<unsigned char>(digits[1])) == name[0])
        digits.erase(0, 2);
    return sign + "0" + name + (name == "d" ? "" : "sm") + "0" + digits;
}

/// Above 64 bits: what it is where somebody wants a plain number.
template <class Self> struct ReadsAsPlain {
    operator std::int64_t() const {  // NOLINT(google-explicit-constructor): as the tools' do
        return static_cast<Self const&>(*this).to_int64();
    }
    explicit operator bool() const { return static_cast<Self const&>(*this) != 0; }
};
struct IsPlain {};

/// SystemC's number `Base` with what the tools' `Self` has besides.
template <class Self, class Base, int bits, bool has_sign>
class Number : public Base, public std::conditional_t<(bits > 64), ReadsAsPlain<Self>, IsPlain> {
  public:
    static constexpr int width = bits;

    Number() = default;
    /// Whatever can be assigned: numbers of any width, ranges, bits, texts.
    template <class From, IfGiven<Base, From> = 0> Number(From const& from) {  // NOLINT(google-explicit-constructor)
        give(from);
    }
    Number(char const* digits, int radix) { Base::operator=(as_magnitude(digits, radix).c_str()); }
    template <class From, IfGiven<Base, From> = 0> Self& operator=(From const& from) {
        give(from);
        return static_cast<Self&>(*this);
    }

    // Bits, the lowest of which has number 0. SystemC's have test(), and a set() that forgets the sign.
    bool get_bit(int index) const { return static_cast<bool>(static_cast<Base const&>(*this)[index]); }
    void set_bit(int index, bool value) { static_cast<Base&>(*this)[index] = value; }
    void set(int index, bool value = true) { set_bit(index, value); }
    void clear(int index) { set_bit(index, false); }
    void invert(int index) { set_bit(index, !get_bit(index)); }
    void reverse() {
        for (int low = 0, high = bits - 1; low < high; ++low, --high) {
            bool const moved = get_bit(low);
            set_bit(low, get_bit(high));
            set_bit(high, moved);
        }
    }
    int countLeadingZeros() const {  // NOLINT(readability-identifier-naming): as the tools have it
        int count = 0;
        while (count < bits && !get_bit(bits - 1 - count))
            ++count;
        return count;
    }

    bool sign() const { return has_sign && static_cast<Base const&>(*this) < 0; }
    /// As (a, b).
    template <class Other> decltype(auto) concat(Other const& other) const {
        return static_cast<Base const&>(*this), other;
    }

  private:
    /// A fixed-point number without its fraction.
    template <class From> void give(From const& from) {
        if constexpr (is_fixed<From> && bits <= 64)
            Base::operator=(static_cast<std::uint64_t>(from.to_int64()));
        else if constexpr (is_fixed<From>)
            Base::operator=(from.to_double());
        else
            Base::operator=(from);
    }
};

/// In hexadecimal a sign, 0x and a magnitude.
template <class Base> std::ostream& print(std::ostream& out, Base const& number) {
    if ((out.flags() & std::ios::basefield) != std::ios::hex)
        return out << number;
    std::string digits = number.to_string(sc_dt::SC_HEX_SM, false);
    std::string const sign = digits[0] == '-' ? "-" : "";
    digits.erase(0, digits.find_first_not_of("-0"));
    return out << sign + "0x" + (digits.empty() ? "0" : digits);
}

template <int bits>
using Signed = std::conditional_t<(bits <= 64), sc_dt::sc_int<bits>, sc_dt::sc_bigint<bits>>;
template <int bits>
using Unsigned = std::conditional_t<(bits <= 64), sc_dt::sc_uint<bits>, sc_dt::sc_biguint<bits>>;

}  // namespace faster_ap

// NOLINTBEGIN(readability-identifier-naming): as the tools have them
template <int bits> class ap_int : public faster_ap::Number<ap_int<bits>, faster_ap::Signed<bits>, bits, true> {
    using Number = faster_ap::Number<ap_int<bits>, faster_ap::Signed<bits>, bits, true>;

  public:
    using Number::Number;
    using Number::operator=;
};
template <int bits> class ap_uint : public faster_ap::Number<ap_uint<bits>, faster_ap::Unsigned<bits>, bits, false> {
    using Number = faster_ap::Number<ap_uint<bits>, faster_ap::Unsigned<bits>, bits, false>;

  public:
    using Number::Number;
    using Number::operator=;
};
// NOLINTEND(readability-identifier-naming)

template <int bits> std::ostream& operator<<(std::ostream& out, ap_int<bits> const& number) {
    return faster_ap::print<faster_ap::Signed<bits>>(out, number);
}
template <int bits> std::ostream& operator<<(std::ostream& out, ap_uint<bits> const& number) {
    return faster_ap::print<faster_ap::Unsigned<bits>>(out, number);
}

#include "ap_fixed.h"  // as the tools' does
