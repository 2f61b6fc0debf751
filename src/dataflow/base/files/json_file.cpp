#include "dataflow/base/files/json_file.hpp"

#include <algorithm>
#include <cstddef>
#include <fmt/format.h>

#include "dataflow/base/files/text_file.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/base/printable.hpp"

namespace dataflow::io {

namespace {

constexpr std::uint64_t most_json_bytes = std::uint64_t{256} << 20U;
constexpr std::size_t deepest = 64;

/// Where arrays and objects are too deep, from 1; 0 if they are not.
std::size_t first_too_deep(std::string_view text) {
    std::size_t depth = 0;
    bool is_in_string = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        char const letter = text[i];
        if (is_in_string) {
            if (letter == '\\')
                ++i;
            else
                is_in_string = letter != '"';
        } else if (letter == '"') {
            is_in_string = true;
        } else if (letter == '[' || letter == '{') {
            if (++depth > deepest)
                return i + 1;
        } else if ((letter == ']' || letter == '}') && depth > 0) {
            --depth;
        }
    }
    return 0;
}

/// The word that parsing stopped in, if Python writes it and JSON does not know it; else nothing.
std::string_view number_of_python(std::string_view text, std::size_t byte) {
    std::string_view const rest = text.substr(std::min(byte - std::min<std::size_t>(byte, 1), text.size()));
    for (std::string_view const word : {"NaN", "Infinity"})
        if (rest.substr(0, word.size()) == word)
            return word;
    return {};
}

/// What keeps a text from being read, found at a byte.
std::string fault_of(std::string_view text, std::size_t byte) {
    if (first_too_deep(text) > 0)
        return fmt::format("has arrays and objects more than {} deep", deepest);
    std::string_view const word = number_of_python(text, byte);
    return word.empty() ? "is cut off or no JSON from here on" : fmt::format("{}, which is no JSON", word);
}

}  // namespace

Json parse_json(std::string_view text) {
    if (std::size_t const byte = first_too_deep(text); byte > 0)
        throw Json::parse_error::create(101, byte, "arrays and objects too deep", nullptr);
    return Json::parse(text);
}

Json read_json_file(std::filesystem::path const& path, std::string const& expected) {
    std::string const text = read_file(path, expected, most_json_bytes);
    try {
        return parse_json(text);
    } catch (Json::parse_error const& error) {
        auto const end = text.begin() + static_cast<std::ptrdiff_t>(std::min(error.byte, text.size()));
        throw InputError(fmt::format("{}:{}: {}, expected {}", path.string(), std::count(text.begin(), end, '\n') + 1,
                                     fault_of(text, error.byte), expected));
    } catch (Json::exception const&) {  // no other is documented, and it is what a number like 1e999 gives
        throw InputError(fmt::format("{}: holds a number beyond all limits, expected {}", path.string(), expected));
    }
}

std::string shown(Json const& value) {
    if (value.is_array())
        return fmt::format("an array of {}", value.size());
    if (value.is_object())
        return "an object";
    return shortened(value.dump());
}

std::string text_of(Json const& value, int indent) {
    return value.dump(indent, ' ', true, Json::error_handler_t::replace);
}

}  // namespace dataflow::io
