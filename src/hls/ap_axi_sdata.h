#pragma once
// ap_axiu and ap_axis by the names of Vivado HLS and Vitis HLS: what an AXI4-Stream carries. As a token it is as wide
// as the signals that are there; one of width 0 is not there, and reads as 0.
#include <type_traits>

#include "ap_int.h"

namespace faster_ap {

/// A signal that the stream does not have.
struct NoSignal {
    NoSignal() = default;
    template <class Any> NoSignal(Any const& /*value*/) {}  // NOLINT(google-explicit-constructor): as a number is given
    operator int() const { return 0; }                      // NOLINT(google-explicit-constructor)
};
template <int bits> using Signal = std::conditional_t<(bits > 0), ap_uint<(bits > 0 ? bits : 1)>, NoSignal>;

template <class Data, int data_bits, int user_bits, int id_bits, int dest_bits> struct AxiWord {
    static constexpr int bytes = (data_bits + 7) / 8;
    static constexpr unsigned bits = data_bits + 2 * bytes + user_bits + 1 + id_bits + dest_bits;

    Data data;
    ap_uint<bytes> keep, strb;
    Signal<user_bits> user;
    ap_uint<1> last;
    Signal<id_bits> id;
    Signal<dest_bits> dest;
};

}  // namespace faster_ap

// NOLINTBEGIN(readability-identifier-naming): as the tools have them
template <int data_bits, int user_bits, int id_bits, int dest_bits>
using ap_axiu = faster_ap::AxiWord<ap_uint<data_bits>, data_bits, user_bits, id_bits, dest_bits>;
template <int data_bits, int user_bits, int id_bits, int dest_bits>
using ap_axis = faster_ap::AxiWord<ap_int<data_bits>, data_bits, user_bits, id_bits, dest_bits>;
// NOLINTEND(readability-identifier-naming)
