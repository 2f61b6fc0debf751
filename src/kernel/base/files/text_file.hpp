#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace faster::io {

/// Throws InputError if there is no such file, or a folder in its place.
void require_file(std::filesystem::path const& path);

/// The whole content of a regular file. Throws InputError if it is missing, a folder or unreadable.
std::string read_file(std::filesystem::path const& path);

/// Replaces the content of a file. Throws InputError if it cannot be written completely.
void write_file(std::filesystem::path const& path, std::string_view content);

}  // namespace faster::io
