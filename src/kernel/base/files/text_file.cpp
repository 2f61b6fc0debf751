#include "kernel/base/files/text_file.hpp"

#include <fstream>

#include "kernel/base/files/file_error.hpp"

namespace faster::io {

void require_file(std::filesystem::path const& path) {
    std::error_code ignored;
    auto const status = std::filesystem::status(path, ignored);
    if (!std::filesystem::exists(status)) {
        fail(path, "no such file, expected a readable file");
    }
    if (std::filesystem::is_directory(status)) {
        fail(path, "is a folder, expected a file");
    }
}

std::string read_file(std::filesystem::path const& path) {
    require_file(path);
    std::error_code ignored;
    std::ifstream stream(path, std::ios::binary);
    std::string content;
    if (stream) {
        auto const size = std::filesystem::file_size(path, ignored);
        content.resize(ignored ? 0 : static_cast<std::size_t>(size));
        stream.read(content.data(), static_cast<std::streamsize>(content.size()));
    }
    if (!stream) {
        fail(path, "cannot be read, expected a readable file");
    }
    return content;
}

void write_file(std::filesystem::path const& path, std::string_view content) {
    std::ofstream stream(path, std::ios::binary | std::ios::trunc);
    stream.write(content.data(), static_cast<std::streamsize>(content.size()));
    stream.close();
    if (!stream) {
        fail(path, "cannot be written");
    }
}

}  // namespace faster::io
