#include "dataflow/base/files/durable_file.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <system_error>
#include <unistd.h>

#include "dataflow/base/files/file_error.hpp"
#include "dataflow/base/files/scratch.hpp"
#include "dataflow/base/files/text_file.hpp"

namespace dataflow::io {

namespace {

/// Some file systems cannot sync a folder, and need not: no reason to give up.
bool sync(std::filesystem::path const& path, int flags) {
    int const file = open(path.c_str(), flags | O_CLOEXEC);
    if (file < 0)
        return false;
    bool const done = fsync(file) == 0;
    close(file);
    return done;
}

}  // namespace

void write_file_durably(std::filesystem::path const& path, std::string_view content) {
    try {
        Scratch const scratch(std::filesystem::absolute(path), Scratch::Kind::file);
        write_file(scratch.path(), content);
        if (!sync(scratch.path(), O_RDONLY))
            fail_to_write(path, std::strerror(errno));
        scratch.replace_target();
    } catch (std::filesystem::filesystem_error const& error) {
        fail_to_write(path, error.code().message());
    }
    sync_folder_of(path);
}

void sync_folder_of(std::filesystem::path const& file) {
    std::filesystem::path const folder = file.parent_path();
    sync(folder.empty() ? "." : folder, O_RDONLY | O_DIRECTORY);
}

}  // namespace dataflow::io
