#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace dataflow::io {

/// What read_file() reads unless it is told otherwise: more than any table or image of ours has.
constexpr std::uint64_t most_file_bytes = std::uint64_t{4} << 30U;

/// Throws InputError if there is no such file, a folder in its place, or links that lead nowhere.
void require_file(std::filesystem::path const& path, std::string const& expected = "a readable file");

/// Throws InputError if there is no such folder, or a file in its place; `expected` says what it should have been.
void require_folder(std::filesystem::path const& path, std::string const& expected);

/// The whole content of a file, or of what a pipe brings. Throws InputError if it is missing, a folder, unreadable or
/// longer than `most_bytes`, of which no more is read; `expected` says what it should have been. HostError if it is
/// there, but cannot be read.
std::string read_file(std::filesystem::path const& path, std::string const& expected = "a readable file",
                      std::uint64_t most_bytes = most_file_bytes);

/// Replaces the content of a file. Throws InputError if it cannot be written completely, and Interrupted if a signal is
/// held back (HeldSignals): of many files the next is not begun.
void write_file(std::filesystem::path const& path, std::string_view content);

}  // namespace dataflow::io
