#include "kernel/base/files/linked_copy.hpp"

#include <system_error>

namespace faster::io {

namespace fs = std::filesystem;

void copy_as_links(fs::path const& from, fs::path const& to) {
    if (fs::is_symlink(fs::symlink_status(from)))
        return fs::copy_symlink(from, to);
    if (fs::is_directory(from)) {
        fs::create_directory(to, from);  // with its permissions
        for (auto const& entry : fs::directory_iterator(from))
            copy_as_links(entry.path(), to / entry.path().filename());
        return;
    }
    std::error_code error;
    fs::create_hard_link(from, to, error);
    if (error) {
        fs::copy_file(from, to);
        fs::last_write_time(to, fs::last_write_time(from));
    }
}

}  // namespace faster::io
