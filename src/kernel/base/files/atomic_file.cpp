#include "kernel/base/files/atomic_file.hpp"

#include <string>
#include <system_error>

#include "kernel/base/files/file_error.hpp"
#include "kernel/base/files/partial_file.hpp"
#include "kernel/base/files/text_file.hpp"

namespace faster::io {
namespace {

namespace fs = std::filesystem;

/// The file behind symbolic links: renaming onto a link would replace the link.
fs::path file_behind(fs::path const& path) {
    if (!path.has_filename()) {
        throw InputError("\"" + path.string() + "\" names no file, expected a path to write to");
    }
    fs::path file = fs::weakly_canonical(fs::absolute(path));
    if (fs::exists(file) && !fs::is_regular_file(file)) {
        fail(path, "is no regular file, expected a new file or one to replace");
    }
    return file;
}

}  // namespace

void write_file_atomically(fs::path const& path, std::string_view content) {
    try {
        fs::path const file = file_behind(path);
        if (!fs::is_directory(file.parent_path())) {
            fail_to_write(path, "its folder does not exist");
        }
        PartialFile const partial(file);
        write_file(partial.path(), content);
        fs::rename(partial.path(), file);
    } catch (fs::filesystem_error const& error) {
        fail_to_write(path, error.code().message());
    }
}

}  // namespace faster::io
