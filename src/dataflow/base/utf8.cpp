#include "dataflow/base/utf8.hpp"

#include <algorithm>
#include <array>
#include <utf8cpp/utf8.h>

namespace dataflow {

namespace {

struct CodeRange {
    char32_t first, last;
    bool holds(char32_t code) const { return code >= first && code <= last; }
};

}  // namespace

Utf8Character first_character(std::string_view text) {
    auto end = text.begin();
    try {
        char32_t const code = utf8::next(end, text.end());
        return {static_cast<std::size_t>(end - text.begin()), code, true};
    } catch (utf8::exception const&) {
        return {};
    }
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
