#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "dataflow/base/files/scratch.hpp"

namespace dataflow::recording {

/// A file that has its name once it is finished, and until then a hidden one beside it. A device or a pipe is written
/// to at once.
class UnfinishedFile {
  public:
    explicit UnfinishedFile(std::filesystem::path file);

    /// Where to write.
    std::string path() const { return (scratch_ ? scratch_->path() : file_).string(); }
    /// It is written, and closed.
    void finish();
    /// Throws InputError with what the system said last.
    [[noreturn]] void fail() const;

  private:
    std::filesystem::path file_;
    std::optional<io::Scratch> scratch_;
};

}  // namespace dataflow::recording
