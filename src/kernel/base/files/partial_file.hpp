#pragma once
#include <filesystem>
#include <system_error>

#include "kernel/base/files/hidden_name.hpp"

namespace faster::io {

/// A hidden file beside `file`, with a name that two programs at once will not share; removed unless renamed.
class PartialFile {
  public:
    explicit PartialFile(std::filesystem::path const& file) : path_(hidden_name(file, "partial")) {}
    ~PartialFile() {
        std::error_code ignored;
        std::filesystem::remove(path_, ignored);
    }
    PartialFile(PartialFile const&) = delete;
    PartialFile& operator=(PartialFile const&) = delete;

    std::filesystem::path const& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

}  // namespace faster::io
