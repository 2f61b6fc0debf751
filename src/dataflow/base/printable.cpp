#include "dataflow/base/printable.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <iterator>

#include "dataflow/base/utf8.hpp"

namespace dataflow {

namespace {

constexpr std::string_view ellipsis = "...";

/// Lengths in bytes; a cut is moved so that no character is cut.
constexpr std::size_t longest_value = 80;
constexpr std::size_t longest_word = 300;  ///< of a message; paths are rarely longer
constexpr std::size_t longest_message = 2000;

std::string escape(char32_t code) {
    switch (code) {
        case '\n':
            return "\\n";
        case '\r':
            return "\\r";
        case '\t':
            return "\\t";
        default:
            break;
    }
    auto const number = static_cast<unsigned>(code);
    if (code < 0x80)
        return fmt::format("\\x{:02x}", number);
    return code <= 0xFFFF ? fmt::format("\\u{:04x}", number) : fmt::format("\\U{:08x}", number);
}

/// Blanks that are none to a reader of files, and letters without a picture.
bool is_seen(char32_t code) {
    constexpr std::array<char32_t, 8> none{0xA0, 0xAD, 0x200B, 0x200C, 0x200D, 0x202F, 0x2060, 0xFEFF};
    return is_printable(code) && std::find(none.begin(), none.end(), code) == none.end();
}

bool is_layout(char32_t code) { return code == '\n' || code == '\t'; }

std::string escaped(std::string_view text, bool keeps_layout) {
    std::string result;
    result.reserve(text.size());
    while (!text.empty()) {
        Utf8Character const character = first_character(text);
        if (!character.is_valid)
            result += fmt::format("\\x{:02x}", static_cast<unsigned char>(text.front()));
        else if (is_seen(character.code) || (keeps_layout && is_layout(character.code)))
            result += text.substr(0, character.bytes);
        else
            result += escape(character.code);
        text.remove_prefix(character.bytes);
    }
    return result;
}

bool is_inside_character(std::string_view text, std::size_t place) {
    return place > 0 && place < text.size() && (static_cast<unsigned char>(text[place]) & 0xC0U) == 0x80U;
}

std::string_view head(std::string_view text, std::size_t bytes) {
    while (is_inside_character(text, bytes))
        --bytes;
    return text.substr(0, bytes);
}

std::string_view tail(std::string_view text, std::size_t bytes) {
    std::size_t from = text.size() - bytes;
    while (is_inside_character(text, from))
        ++from;
    return text.substr(from);
}

void append_without_middle(std::string_view text, std::size_t longest, std::string& result) {
    if (text.size() <= longest) {
        result += text;
        return;
    }
    std::size_t const half = longest / 2;
    result.append(head(text, half)).append(ellipsis).append(tail(text, half));
}

std::string with_short_words(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        std::size_t const end = text.find(' ');
        append_without_middle(text.substr(0, end), longest_word, result);
        if (end == std::string_view::npos)
            break;
        result += ' ';
        text.remove_prefix(end + 1);
    }
    return result;
}

}  // namespace

std::string printable(std::string_view text) { return escaped(text, false); }

std::string printable_lines(std::string_view text) { return escaped(text, true); }

std::string shortened(std::string_view text) {
    std::string_view const start = head(text, longest_value);
    return start.size() < text.size() ? printable(start).append(ellipsis) : printable(start);
}

std::string message_line(std::string_view text) {
    std::string line;
    append_without_middle(with_short_words(printable(text.substr(0, text.find_last_not_of('\n') + 1))), longest_message,
                          line);
    return line;
}

}  // namespace dataflow
