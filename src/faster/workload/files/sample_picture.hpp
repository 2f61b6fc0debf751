#pragma once
#include <cstddef>
#include <filesystem>
#include <string>

namespace faster::files {

/// The name of a picture of one sample: FOLDER/sample_0007_edges.png.
std::filesystem::path sample_picture(std::filesystem::path const& folder, std::size_t sample,
                                     std::string const& content);

}  // namespace faster::files
