#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace dataflow::io {

/// A hidden name beside `file`, which two programs at once will not share: ".NAME.PURPOSE-NUMBER". What is written
/// under it gets its own name once it is whole. Purposes: partial, older.
std::filesystem::path hidden_name(std::filesystem::path const& file, std::string const& purpose);

/// All that has such a name of `file`; as many as can be listed.
std::vector<std::filesystem::path> all_hidden_beside(std::filesystem::path const& file, std::string const& purpose);

/// All that has such a name of any file in `folder`.
std::vector<std::filesystem::path> all_hidden_in(std::filesystem::path const& folder, std::string const& purpose);

/// The path as people know it: the names that hidden_name() made of its parts, undone.
std::filesystem::path without_hidden_names(std::filesystem::path const& path);

}  // namespace dataflow::io
