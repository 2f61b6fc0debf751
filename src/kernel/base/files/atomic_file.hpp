#pragma once
#include <filesystem>
#include <string_view>

namespace faster::io {

/// Writes a file that appears complete or not at all: under a hidden name beside it, which is then renamed. An older
/// file is replaced; its folder must exist. Throws InputError if the path is no regular file or cannot be written.
void write_file_atomically(std::filesystem::path const& path, std::string_view content);

}  // namespace faster::io
