#include "dataflow/base/utf8.hpp"

#include <algorithm>
#include <array>

namespace dataflow {

namespace {

struct CodeRange {
    char32_t first, last;
    bool holds(char32_t code) const { return code >= first && code <= last; }
};

/// Bytes of the character that starts with `lead`; 0 if none does. C0, C1 and F5 upwards never occur.
std::size_t length_of(unsigned char lead) {
    if (lead < 0x80)
        return 1;
    if (lead >= 0xC2 && lead <= 0xDF)
        return 2;
    if (lead >= 0xE0 && lead <= 0xEF)
        return 3;
    return lead >= 0xF0 && lead <= 0xF4 ? 4 : 0;
}

/// Excludes overlong forms, surrogates and code points beyond 10FFFF.
bool is_in_shortest_form(char32_t code, std::size_t bytes) {
    constexpr std::array<char32_t, 5> least{0, 0, 0x80, 0x800, 0x10000};
    return code >= least[bytes] && code <= 0x10FFFF && !CodeRange{0xD800, 0xDFFF}.holds(code);
}

}  // namespace

Utf8Character first_character(std::string_view text) {
    auto const lead = static_cast<unsigned char>(text.front());
    std::size_t const length = length_of(lead);
    if (length == 0 || length > text.size())
        return {};
    char32_t code = length == 1 ? lead : lead & (0x7FU >> length);
    for (std::size_t i = 1; i < length; ++i) {
        auto const byte = static_cast<unsigned char>(text[i]);
        if ((byte & 0xC0U) != 0x80U)
            return {};
        code = code << 6U | (byte & 0x3FU);
    }
    return is_in_shortest_form(code, length) ? Utf8Character{length, code, true} : Utf8Character{};
}

bool is_printable(char32_t code) {
    constexpr std::array<CodeRange, 7> none{{{0, 0x1F},
                                             {0x7F, 0x9F},
                                             {0x061C, 0x061C},
                                             {0x200E, 0x200F},
                                             {0x2028, 0x202E},
                                             {0x2066, 0x2069},
                                             {0xE0000, 0xE007F}}};
    return std::none_of(none.begin(), none.end(), [code](CodeRange const& range) { return range.holds(code); });
}

std::optional<std::size_t> first_bad_byte(std::string_view text) {
    for (std::size_t index = 0; index < text.size();) {
        Utf8Character const character = first_character(text.substr(index));
        bool const is_layout = text[index] == '\t' || text[index] == '\n' || text[index] == '\r';
        if (!character.is_valid || (!is_printable(character.code) && !is_layout))
            return index;
        index += character.bytes;
    }
    return std::nullopt;
}

}  // namespace dataflow
