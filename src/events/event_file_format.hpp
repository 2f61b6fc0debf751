#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace faster::events {

/// Where what lies in an event file: opening, header frame, a frame per sample, index frame, closing. Numbers are
/// little-endian.
constexpr std::string_view opening_mark = "FASTEREV";
constexpr std::string_view closing_mark = "FASTERND";
constexpr std::uint32_t format_version = 2;
constexpr std::size_t opening_bytes = 16;  ///< mark, version (32 bits), bytes of the header frame (32 bits)
constexpr std::size_t closing_bytes = 24;  ///< offset and bytes of the index frame (64 bits each), mark

template <class Number> std::string little_endian(Number value) {
    std::string bytes;
    for (std::size_t i = 0; i < sizeof value; ++i)
        bytes.push_back(static_cast<char>((value >> (8 * i)) & 0xFFU));
    return bytes;
}

template <class Number> Number from_little_endian(std::string_view bytes) {
    Number value = 0;
    for (std::size_t i = 0; i < sizeof value; ++i)
        value |= static_cast<Number>(Number{static_cast<unsigned char>(bytes[i])} << (8 * i));
    return value;
}

}  // namespace faster::events
