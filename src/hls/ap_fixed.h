#pragma once
// ap_fixed and ap_ufixed by the tools' names: SystemC's fixed-point numbers, whose quantization and overflow modes are
// those of the tools. Results of operations are exact (sc_fxval), and are cut where they are assigned; a division has
// 64 bits. range() gives SystemC's bits.
#include <systemc>
#include <sysc/datatypes/fx/fx.h>

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
// NOLINTEND(readability-identifier-naming)

template <int width, int integer_bits, ap_q_mode quantization = AP_TRN, ap_o_mode overflow = AP_WRAP>
using ap_fixed = sc_dt::sc_fixed<width, integer_bits, quantization, overflow>;  // NOLINT
template <int width, int integer_bits, ap_q_mode quantization = AP_TRN, ap_o_mode overflow = AP_WRAP>
using ap_ufixed = sc_dt::sc_ufixed<width, integer_bits, quantization, overflow>;  // NOLINT
