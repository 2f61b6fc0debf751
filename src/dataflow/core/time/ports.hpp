#pragma once
#include <cstdint>
#include <vector>

namespace dataflow::timing {

/// Ports of one process that are accessed together. A number stands for them: below 256 it is a mask of the first eight
/// ports, a bit each; from there on it is that of a set with other ports in it, of which the program keeps a list. So a
/// process may have any number of ports, and those of a process with few ports need no list.
class Ports {
  public:
    using Number = std::uint16_t;
    static constexpr unsigned number_bits = 11;
    static constexpr Number masks = 256;                 ///< numbers below are masks
    static constexpr Number numbers = 1 << number_bits;  ///< and so many sets there are at most
    static constexpr unsigned in_masks = 8;              ///< ports

    constexpr Ports() = default;  ///< none
    explicit Ports(Number number) : number_(number) {}
    static Ports of(unsigned port) { return port < in_masks ? Ports(static_cast<Number>(1U << port)) : kept({port}); }
    /// In any order.
    static Ports of(std::vector<unsigned> const& ports);
    /// Whether that can be had of ascending ports: what is read from a file may say anything.
    static bool has_room_for(std::vector<unsigned> const& ports);

    Number number() const { return number_; }
    bool is_empty() const { return number_ == 0; }
    static bool is_mask(Number number) { return number < masks; }
    /// Whether there is such a set.
    static bool is_known(std::uint64_t number);

    /// Visits each port's number, in program order.
    template <class Visit> void each(Visit visit) const {
        if (is_mask(number_)) {
            for (std::uint32_t mask = number_; mask != 0; mask &= mask - 1)
                visit(static_cast<unsigned>(__builtin_ctz(mask)));
            return;
        }
        for (unsigned const port : list(number_))
            visit(port);
    }
    bool has(unsigned port) const;
    unsigned first() const {
        return is_mask(number_) ? static_cast<unsigned>(__builtin_ctz(number_)) : list(number_)[0];
    }

    friend Ports operator|(Ports one, Ports other) {
        if (is_mask(one.number_) && is_mask(other.number_))
            return Ports(static_cast<Number>(one.number_ | other.number_));
        return joined(one, other);
    }
    friend bool operator==(Ports one, Ports other) { return one.number_ == other.number_; }
    friend bool operator!=(Ports one, Ports other) { return one.number_ != other.number_; }

  private:
    /// Ascending, not all below in_masks.
    static Ports kept(std::vector<unsigned> const& ports);
    static Ports joined(Ports one, Ports other);
    static std::vector<unsigned> const& list(Number number);

    Number number_ = 0;
};

constexpr Ports no_ports;

}  // namespace dataflow::timing
