#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "dataflow/base/little_endian.hpp"
#include "dataflow/run/config/load_config.hpp"

namespace dataflow::events {

/// Where what lies in an event file: opening, header frame, a frame per sample, index frame, closing. Numbers are
/// little-endian.
constexpr std::string_view opening_mark = event_file_mark;
constexpr std::string_view closing_mark = "FASTERND";
constexpr std::uint32_t format_version = 5;
constexpr std::size_t opening_bytes = 16;  ///< mark, version (32 bits), bytes of the header frame (32 bits)
constexpr std::size_t closing_bytes = 24;  ///< offset and bytes of the index frame (64 bits each), mark

template <class Number> std::string little_endian(Number value) {
    std::string bytes(sizeof value, '\0');
    put_little_endian<sizeof value>(value, bytes.data());
    return bytes;
}

template <class Number> Number from_little_endian(std::string_view bytes) {
    return static_cast<Number>(little_endian_at<sizeof(Number)>(bytes.data()));
}

}  // namespace dataflow::events
