#pragma once
// ap_shift_reg by the name of Vivado HLS and Vitis HLS: a shift register with an address. In a design it takes no time,
// like the arrays of a function.
#include <array>

// NOLINTBEGIN(readability-identifier-naming): as the tools have it
template <class Value, unsigned depth = 32> class ap_shift_reg {
  public:
    ap_shift_reg() = default;
    explicit ap_shift_reg(char const* /*name*/) {}
    ap_shift_reg(ap_shift_reg const&) = delete;
    ap_shift_reg& operator=(ap_shift_reg const&) = delete;

    /// What is at that address; then all move up by one, and `in` comes to address 0.
    Value shift(Value in, unsigned address = depth - 1, bool is_enabled = true) {
        Value const out = read(address);
        if (is_enabled) {
            for (unsigned i = depth - 1; i > 0; --i)
                values_[i] = values_[i - 1];
            values_[0] = in;
        }
        return out;
    }
    Value read(unsigned address = depth - 1) const { return values_.at(address); }

  private:
    std::array<Value, depth> values_{};
};
// NOLINTEND(readability-identifier-naming)
