#pragma once
#include <filesystem>
#include <string>
#include <string_view>

#include "dataflow/base/json.hpp"

namespace dataflow::io {

/// Json::parse() of text from outside: throws Json::parse_error also where arrays and objects are more than 64 deep.
Json parse_json(std::string_view text);

/// The JSON of a file of at most 256 MiB. Throws InputError (file:line) if it is none, for example cut off; `expected`
/// ends the message.
Json read_json_file(std::filesystem::path const& path, std::string const& expected);

/// A value for a message: on one line, and not the whole of a large table.
std::string shown(Json const& value);

/// JSON for a file, lines indented if `indent` is not negative. All of it is ASCII, other characters are escaped; what
/// is no UTF-8 (a file's name may be anything) becomes U+FFFD.
std::string text_of(Json const& value, int indent = -1);

}  // namespace dataflow::io
