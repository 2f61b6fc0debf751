#pragma once
// ap_fixed and ap_ufixed by the tools' names: SystemC's fixed-point numbers, whose quantization and overflow modes are
// those of the tools. Results of operations are exact (sc_fxval), and are cut where they are assigned; a division has
// 64 bits. range() gives SystemC's bits. They are printed as a double is.
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
    int length() const { return this->wl(); }
};

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
