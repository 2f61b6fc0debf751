#pragma once
// ap_int and ap_uint by the tools' names: SystemC's integers of any width. The same are value, wrapping, bits ([]),
// ranges (range(high, low), (high, low)), shifts and comparisons. Not the same: up to 64 bits, the result of an
// operation is a plain 64-bit number and not one as wide as both operands need (a product of two ap_int<40> overflows);
// `auto` and the deduction of N in a function template do not work; concat() is SystemC's, (a, b). docs/hls.md has more.
#include <systemc>
#include <type_traits>

#include "ap_operators.h"

template <int width>
using ap_int = std::conditional_t<(width <= 64), sc_dt::sc_int<width>, sc_dt::sc_bigint<width>>;  // NOLINT
template <int width>
using ap_uint = std::conditional_t<(width <= 64), sc_dt::sc_uint<width>, sc_dt::sc_biguint<width>>;  // NOLINT
