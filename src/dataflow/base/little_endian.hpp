#pragma once
#include <cstddef>
#include <cstdint>

namespace dataflow {

/// The lowest `width` bytes of a number, the lowest first.
template <std::size_t width> void put_little_endian(std::uint64_t number, char* bytes) {
    for (std::size_t i = 0; i < width; ++i)
        bytes[i] = static_cast<char>(number >> (8 * i));
}

/// And back.
template <std::size_t width> std::uint64_t little_endian_at(char const* bytes) {
    std::uint64_t number = 0;
    for (std::size_t i = 0; i < width; ++i)
        number |= std::uint64_t{static_cast<unsigned char>(bytes[i])} << (8 * i);
    return number;
}

}  // namespace dataflow
