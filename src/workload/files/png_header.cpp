#include "workload/files/png_header.hpp"

#include <array>
#include <cstddef>

namespace faster::io {
namespace {

constexpr std::string_view signature{"\x89PNG\r\n\x1a\n", 8};
constexpr std::size_t length_bytes = 4, type_bytes = 4, checksum_bytes = 4, header_bytes = 13;

std::uint32_t byte_at(std::string_view bytes, std::size_t position) {
    return static_cast<unsigned char>(bytes[position]);
}

std::uint32_t big_endian_at(std::string_view bytes, std::size_t position) {
    return byte_at(bytes, position) << 24 | byte_at(bytes, position + 1) << 16 | byte_at(bytes, position + 2) << 8 |
           byte_at(bytes, position + 3);
}

std::array<std::uint32_t, 256> crc_table() {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t index = 0; index < table.size(); ++index) {
        std::uint32_t value = index;
        for (int bit = 0; bit < 8; ++bit) {
            value = (value & 1) != 0 ? 0xEDB88320U ^ (value >> 1) : value >> 1;
        }
        table[index] = value;
    }
    return table;
}

std::uint32_t crc32(std::string_view bytes) {
    static std::array<std::uint32_t, 256> const table = crc_table();
    std::uint32_t value = 0xFFFFFFFFU;
    for (std::size_t position = 0; position < bytes.size(); ++position) {
        value = table[(value ^ byte_at(bytes, position)) & 0xFF] ^ (value >> 8);
    }
    return ~value;
}

PngHeader parse_header(std::string_view data) {
    PngHeader header;
    header.width = big_endian_at(data, 0);
    header.height = big_endian_at(data, 4);
    header.bit_depth = static_cast<int>(byte_at(data, 8));
    header.colour_type = static_cast<int>(byte_at(data, 9));
    return header;
}

}  // namespace

std::string PngHeader::pixel_type() const {
    std::string colour = "unknown colour type";
    switch (colour_type) {
        case 0:
            colour = "greyscale";
            break;
        case 2:
            colour = "RGB";
            break;
        case 3:
            colour = "palette";
            break;
        case 4:
            colour = "greyscale with alpha";
            break;
        case 6:
            colour = "RGB with alpha";
            break;
        default:
            break;
    }
    return (bit_depth == 8 ? "an " : "a ") + std::to_string(bit_depth) + "-bit " + colour;
}

PngCheck check_png(std::string_view file) {
    if (file.substr(0, signature.size()) != signature) {
        return {{}, "is not a PNG file"};
    }
    PngCheck check;
    file.remove_prefix(signature.size());
    for (bool first = true;; first = false) {
        if (file.size() < length_bytes + type_bytes + checksum_bytes ||
            big_endian_at(file, 0) > file.size() - length_bytes - type_bytes - checksum_bytes) {
            return {check.header, "is a truncated PNG file"};
        }
        std::size_t const data_bytes = big_endian_at(file, 0);
        std::string_view const type_and_data = file.substr(length_bytes, type_bytes + data_bytes);
        std::string_view const type = type_and_data.substr(0, type_bytes);
        if (crc32(type_and_data) != big_endian_at(file, length_bytes + type_bytes + data_bytes) ||
            first != (type == "IHDR") || (first && data_bytes != header_bytes)) {
            return {check.header, "is a damaged PNG file"};
        }
        if (first) {
            check.header = parse_header(type_and_data.substr(type_bytes));
        }
        if (type == "IEND") {
            return check;
        }
        file.remove_prefix(length_bytes + type_and_data.size() + checksum_bytes);
    }
}

}  // namespace faster::io
