#include "kernel/recording/unfinished_file.hpp"

#include <cerrno>
#include <cstring>
#include <fmt/format.h>
#include <utility>

#include "kernel/base/input_error.hpp"

namespace faster::recording {

UnfinishedFile::UnfinishedFile(std::filesystem::path file) : file_(std::move(file)) {
    std::error_code none;
    if (!std::filesystem::exists(file_, none) || std::filesystem::is_regular_file(file_, none))
        partial_.emplace(file_);
}

void UnfinishedFile::finish() {
    std::error_code error;
    if (partial_)
        std::filesystem::rename(partial_->path(), file_, error);
    if (error) {
        errno = error.value();
        fail();
    }
}

void UnfinishedFile::fail() const {
    throw InputError(
        fmt::format("{}: cannot be written: {}, expected a file in a folder that is there, and room for it",
                    file_.string(), std::strerror(errno)));
}

}  // namespace faster::recording
