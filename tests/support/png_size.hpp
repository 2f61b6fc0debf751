#pragma once
#include <cstdint>
#include <string>
#include <utility>

namespace faster::test {

/// Width and height [pixels] that the header of a PNG file states, for tests that need no more of a picture: to decode
/// it with OpenCV takes a hundred libraries, which every test of the executable would have to load.
inline std::pair<std::uint32_t, std::uint32_t> png_size(std::string const& file) {
    auto const number_at = [&file](std::size_t at) {
        std::uint32_t number = 0;
        for (char const byte : file.substr(at, 4))
            number = number << 8U | static_cast<unsigned char>(byte);
        return number;
    };
    if (file.compare(0, 8, "\x89PNG\r\n\x1a\n") != 0 || file.size() < 24)
        return {0, 0};
    return {number_at(16), number_at(20)};
}

}  // namespace faster::test
