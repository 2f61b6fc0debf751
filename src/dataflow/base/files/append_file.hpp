#pragma once
#include <filesystem>
#include <string_view>

namespace dataflow::io {

/// A file that only grows, and keeps what it was given even if the power goes.
class AppendFile {
  public:
    /// Made if there is none. Throws InputError if it cannot be written.
    explicit AppendFile(std::filesystem::path const& path);
    ~AppendFile();
    AppendFile(AppendFile const&) = delete;
    AppendFile& operator=(AppendFile const&) = delete;

    /// Is on the disk when the call returns. Otherwise, say because the disk is full, the file is as it was before, as
    /// far as the system allows, and an InputError says why.
    void append(std::string_view bytes);

  private:
    [[noreturn]] void fail(int error) const;

    std::filesystem::path path_;
    int file_;
};

}  // namespace dataflow::io
