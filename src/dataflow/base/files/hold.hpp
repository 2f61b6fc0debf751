#pragma once
#include <filesystem>
#include <memory>

namespace dataflow::io {

/// Shows other processes that a file or folder is in use, for as long as this lives and its process does (flock). Where
/// the file system has no such locks, nobody gets one.
class Hold {
  public:
    /// Throws std::filesystem::filesystem_error if it cannot be opened.
    explicit Hold(std::filesystem::path const& path);
    ~Hold();
    Hold(Hold const&) = delete;
    Hold& operator=(Hold const&) = delete;

    bool is_held() const { return error_ == 0; }
    bool is_held_by_another() const;
    /// Whether what was opened still has that name.
    bool is_at(std::filesystem::path const& path) const;

  private:
    int descriptor_;
    int error_ = 0;  // why it is not held
};

/// For what may be left of another process: null if it is in use, may not be opened, or is gone.
std::unique_ptr<Hold> hold_if_free(std::filesystem::path const& path);

}  // namespace dataflow::io
