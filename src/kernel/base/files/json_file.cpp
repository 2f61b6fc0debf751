#include "kernel/base/files/json_file.hpp"

#include <algorithm>
#include <cstddef>
#include <fmt/format.h>

#include "kernel/base/files/text_file.hpp"
#include "kernel/base/input_error.hpp"
#include "kernel/base/printable.hpp"

namespace faster::io {

Json read_json_file(std::filesystem::path const& path, std::string const& expected) {
    std::string const text = read_file(path);
    try {
        return Json::parse(text);
    } catch (Json::parse_error const& error) {
        auto const end = text.begin() + static_cast<std::ptrdiff_t>(std::min(error.byte, text.size()));
        throw InputError(fmt::format("{}:{}: is cut off or no JSON from here on, expected {}", path.string(),
                                     std::count(text.begin(), end, '\n') + 1, expected));
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

}  // namespace faster::io
