#pragma once
#include <filesystem>

namespace dataflow::io {

/// A folder that one process has to itself while this lives, by a lock on the file .lock in it.
class FolderLock {
  public:
    /// Throws InputError if the folder cannot be written, or another process has it.
    explicit FolderLock(std::filesystem::path const& folder);
    ~FolderLock();
    FolderLock(FolderLock const&) = delete;
    FolderLock& operator=(FolderLock const&) = delete;

  private:
    int file_;
};

}  // namespace dataflow::io
