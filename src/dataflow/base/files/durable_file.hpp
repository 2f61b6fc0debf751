#pragma once
#include <filesystem>
#include <string_view>

namespace dataflow::io {

/// An OutputFile that is on the disk when the call returns: after a power cut there is the old file or the new
/// one. Throws InputError if it cannot be written.
void write_file_durably(std::filesystem::path const& path, std::string_view content);

/// That a file was made or renamed is on the disk too.
void sync_folder_of(std::filesystem::path const& file);

}  // namespace dataflow::io
