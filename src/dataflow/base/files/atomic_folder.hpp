#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "dataflow/base/files/folder_kind.hpp"
#include "dataflow/base/files/scratch.hpp"

namespace dataflow::io {

/// An output folder that appears complete or not at all. Files are written below `path()`, a hidden folder beside the
/// target that is made when it is first asked for; `commit()` gives it its name. Without commit the destructor removes
/// it, so a failed run leaves nothing; nor does one that is killed before it writes.
///
/// The target may be missing (parents are made), empty, or an older folder of the same kind, with which the new one
/// changes places in one step. Files in the older one that are not of that kind (a note, a waveform) are in both before
/// that, as links to the same file, or copies where a file system has no links. The folder, and files in it that are
/// written anew, keep their rights. Anything else, a place that cannot be
/// written, and the current folder or one above are an InputError from the constructor: before the work whose output
/// would be lost.
///
/// A file system on which two folders cannot change places (EINVAL of renameat2) takes two renames. A process that is
/// killed between them leaves the older folder as ".NAME.older-NUMBER", and the next AtomicFolder brings it back.
class AtomicFolder {
  public:
    AtomicFolder(std::filesystem::path const& target, FolderKind kind);
    AtomicFolder(AtomicFolder const&) = delete;
    AtomicFolder& operator=(AtomicFolder const&) = delete;

    /// Where to write until commit().
    std::filesystem::path const& path();
    /// Where to write a file that is to be at `file` after commit(): below path() if that is in this folder.
    std::filesystem::path place_of(std::filesystem::path const& file);
    /// The folder as the user named it, for messages.
    std::filesystem::path const& target() const { return target_; }
    void commit();

  private:
    void require_place() const;
    void require_folder(std::filesystem::path const& place) const;
    void require_replaceable() const;
    bool try_to_appear() const;
    bool try_to_replace() const;
    void keep_foreign_files() const;
    void keep_rights_of_older() const;
    [[noreturn]] void fail(std::string const& what) const;
    [[noreturn]] void fail(std::filesystem::filesystem_error const& error) const;

    std::filesystem::path target_;       // as given
    std::filesystem::path destination_;  // absolute, symbolic links resolved
    FolderKind kind_;
    std::optional<Scratch> scratch_;
};

}  // namespace dataflow::io
