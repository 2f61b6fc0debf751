#include "dataflow/base/files/text_file.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fmt/format.h>
#include <fstream>

#include "dataflow/base/files/file_error.hpp"
#include "dataflow/base/files/hidden_name.hpp"
#include "dataflow/base/held_signals.hpp"

namespace dataflow::io {
namespace {

[[noreturn]] void fail_length(std::filesystem::path const& path, std::string const& expected, std::uint64_t most) {
    fail(path, fmt::format("is longer than {} MiB, expected {}", most >> 20U, expected));
}

/// A pipe or a device may bring bytes without end, which memory is not to be filled with.
constexpr std::uint64_t most_stream_bytes = std::uint64_t{1} << 28U;

/// What a pipe or a device brings, which has no size that could be asked for, and files of the kernel's, which say 0.
std::string read_stream(std::ifstream& stream, std::uint64_t most_bytes) {
    std::string content;
    std::array<char, 1U << 16U> buffer;
    while (content.size() <= most_bytes && stream) {
        stream.read(buffer.data(), buffer.size());
        content.append(buffer.data(), static_cast<std::size_t>(stream.gcount()));
    }
    if (stream.eof())
        stream.clear();
    return content;
}

}  // namespace

void require_file(std::filesystem::path const& path, std::string const& expected) {
    std::error_code error;
    auto const status = std::filesystem::status(path, error);
    if (status.type() == std::filesystem::file_type::not_found)
        fail(path, "no such file, expected " + expected);
    if (!std::filesystem::status_known(status))  // a loop of links, a folder that may not be searched
        fail(path, fmt::format("cannot be read ({}), expected {}", error.message(), expected));
    if (std::filesystem::is_directory(status))
        fail(path, "is a folder, expected " + (expected == "a readable file" ? "a file" : expected));
}

void require_folder(std::filesystem::path const& path, std::string const& expected) {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored))
        return;
    bool const is_file = std::filesystem::exists(path, ignored);
    fail(path, is_file ? "is a file, expected a folder: " + expected : "no such folder, expected " + expected);
}

std::string read_file(std::filesystem::path const& path, std::string const& expected, std::uint64_t most_bytes) {
    require_file(path, expected);
    std::error_code no_size;
    auto const size = std::filesystem::file_size(path, no_size);
    bool const is_stream = no_size || size == 0;
    most_bytes = is_stream ? std::min(most_bytes, most_stream_bytes) : most_bytes;
    if (!no_size && size > most_bytes)
        fail_length(path, expected, most_bytes);
    std::ifstream stream(path, std::ios::binary);
    std::string content;
    if (stream && is_stream) {
        content = read_stream(stream, most_bytes);
    } else if (stream) {
        content.resize(static_cast<std::size_t>(size));
        stream.read(content.data(), static_cast<std::streamsize>(content.size()));
    }
    if (!stream)
        throw HostError(path.string() + ": cannot be read, expected " + expected);
    if (content.size() > most_bytes)
        fail_length(path, expected, most_bytes);
    return content;
}

void write_file(std::filesystem::path const& path, std::string_view content) {
    processes::give_up_if_interrupted();
    errno = 0;
    std::ofstream stream(path, std::ios::binary | std::ios::trunc);
    stream.write(content.data(), static_cast<std::streamsize>(content.size()));
    stream.close();
    if (!stream)
        fail_to_write(without_hidden_names(path), errno != 0 ? std::strerror(errno) : "no room for it, or not allowed");
}

}  // namespace dataflow::io
