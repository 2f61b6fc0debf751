#include "dataflow/base/files/folder_lock.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>

#include "dataflow/base/files/file_error.hpp"

namespace dataflow::io {

/// Not flock(): that would be shared with child processes, which may outlive this one by a moment.
FolderLock::FolderLock(std::filesystem::path const& folder)
    : file_(open((folder / ".lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
    if (file_ < 0)
        fail_to_write(folder, std::strerror(errno));
    struct flock whole {};
    whole.l_type = F_WRLCK;
    whole.l_whence = SEEK_SET;
    if (fcntl(file_, F_SETLK, &whole) != 0 && (errno == EACCES || errno == EAGAIN)) {
        close(file_);
        fail(folder, "another faster-sim is at work in it, expected a folder of its own");
    }
}

FolderLock::~FolderLock() { close(file_); }

}  // namespace dataflow::io
