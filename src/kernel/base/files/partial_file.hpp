#pragma once
#include <filesystem>
#include <random>
#include <string>
#include <system_error>

namespace faster::io {

/// A hidden file beside `file`, with a name that two programs at once will not share; removed unless renamed.
class PartialFile {
  public:
    explicit PartialFile(std::filesystem::path const& file) {
        std::random_device random;
        path_ = file.parent_path() / ("." + file.filename().string() + ".partial-" + std::to_string(random()));
    }
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
