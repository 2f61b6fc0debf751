#pragma once
#include <filesystem>

#include "kernel/base/files/folder_kind.hpp"

namespace faster::io {

/// Two folders change names in one step. Where the file system cannot do that, `to` is renamed to a hidden name, `from`
/// becomes `to`, and the former `to` is removed; a process killed in between leaves no `to`, see bring_back_older().
/// False if `to` is gone. Throws std::filesystem::filesystem_error if it cannot be done; both are as before then.
bool exchange_folders(std::filesystem::path const& from, std::filesystem::path const& to);

/// If a process was killed in exchange_folders(): where there is no `folder`, its older one gets its name back; where
/// there is one by now, files of the older one that are not of that kind are moved into it, unless there are such.
/// Throws std::filesystem::filesystem_error.
void bring_back_older(std::filesystem::path const& folder, FolderKind const& kind);

}  // namespace faster::io
