#pragma once
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>
#include <zlib.h>

namespace faster::test {

/// What is in the string of a page's timeline.
inline nlohmann::ordered_json unpacked(std::string const& text) {
    std::string const letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::vector<Bytef> bytes;
    std::uint32_t bits = 0;
    int count = 0;
    for (char const letter : text.substr(0, text.find('='))) {
        bits = (bits << 6) | static_cast<std::uint32_t>(letters.find(letter));
        for (count += 6; count >= 8; count -= 8)
            bytes.push_back(static_cast<Bytef>(bits >> (count - 8)));
    }
    std::vector<Bytef> json(10'000'000);
    uLongf length = json.size();
    REQUIRE(uncompress(json.data(), &length, bytes.data(), bytes.size()) == Z_OK);
    return nlohmann::ordered_json::parse(json.begin(), json.begin() + static_cast<std::ptrdiff_t>(length));
}

}  // namespace faster::test
