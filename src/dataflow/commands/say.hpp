#pragma once
#include <fmt/format.h>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace dataflow {

/// Prints to stdout, with what came from outside escaped: see printable_lines(). Throws InputError if stdout is closed
/// or full.
void say_text(std::string_view text);

template <class... Arguments> void say(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    say_text(fmt::format(format, std::forward<Arguments>(arguments)...));
}

/// Prints to stderr, where a failure has nobody to be told to.
void warn_text(std::string_view text);

template <class... Arguments> void warn(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    warn_text(fmt::format(format, std::forward<Arguments>(arguments)...));
}

/// To stderr, a line each: what looks like a mistake of the input, and lets it be used all the same.
void say_warnings(std::vector<std::string> const& warnings);

/// Names the files and folders that a command has written. Empty names, of what it was not asked for, are left out.
void say_written(std::vector<std::string> const& names);

/// What was said has left the program. Throws InputError if it could not.
void finish_saying();

}  // namespace dataflow
