#pragma once
#include <filesystem>

namespace dataflow::io {

/// What a file or folder `to`, which is about to take the place of `from`, gets of its rights: owner and group as far
/// as the system lets us, and the mode. Where the group cannot be kept, what it may do is no more than what everybody
/// may: it is another group. Nothing if there is no `from`. Throws std::filesystem::filesystem_error if the mode cannot
/// be set.
void keep_rights(std::filesystem::path const& from, std::filesystem::path const& to);

/// Rights of a file while it is being written: those of `from`, and the owner may write whatever `from` says.
void keep_rights_while_writing(std::filesystem::path const& from, std::filesystem::path const& to);

}  // namespace dataflow::io
