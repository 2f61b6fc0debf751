#include "dataflow/base/files/hold.hpp"

#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace dataflow::io {

Hold::Hold(std::filesystem::path const& path)
    : descriptor_(open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOFOLLOW | O_CLOEXEC)) {
    if (descriptor_ < 0)
        throw std::filesystem::filesystem_error("open", path, std::error_code(errno, std::generic_category()));
    if (flock(descriptor_, LOCK_EX | LOCK_NB) != 0)
        error_ = errno;
}

Hold::~Hold() { close(descriptor_); }

bool Hold::is_held_by_another() const { return error_ == EWOULDBLOCK; }

bool Hold::is_at(std::filesystem::path const& path) const {
    struct stat ours {
    }, there{};
    return fstat(descriptor_, &ours) == 0 && lstat(path.c_str(), &there) == 0 && ours.st_dev == there.st_dev &&
           ours.st_ino == there.st_ino;
}

std::unique_ptr<Hold> hold_if_free(std::filesystem::path const& path) try {
    auto hold = std::make_unique<Hold>(path);
    return hold->is_held() ? std::move(hold) : nullptr;
} catch (std::filesystem::filesystem_error const&) {
    return nullptr;
}

}  // namespace dataflow::io
