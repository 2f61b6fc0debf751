#include "dataflow/base/files/append_file.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>

#include "dataflow/base/files/durable_file.hpp"
#include "dataflow/base/files/file_error.hpp"

namespace dataflow::io {

AppendFile::AppendFile(std::filesystem::path const& path)
    : path_(path), file_(open(path.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, 0666)) {
    if (file_ < 0)
        fail(errno);
    sync_folder_of(path);
}

AppendFile::~AppendFile() { close(file_); }

void AppendFile::append(std::string_view bytes) {
    off_t const before = lseek(file_, 0, SEEK_END);
    for (std::size_t done = 0; done < bytes.size();) {
        ssize_t const count = write(file_, bytes.data() + done, bytes.size() - done);
        if (count < 0 && errno == EINTR)
            continue;
        if (count < 0) {
            int const error = errno;
            if (ftruncate(file_, before) != 0)
                fail(errno);
            fail(error);
        }
        done += static_cast<std::size_t>(count);
    }
    if (fdatasync(file_) != 0)
        fail(errno);
}

void AppendFile::fail(int error) const { fail_to_write(path_, std::strerror(error)); }

}  // namespace dataflow::io
