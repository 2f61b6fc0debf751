#include "kernel/base/files/output_file.hpp"

#include <fstream>
#include <string>
#include <system_error>

#include "kernel/base/files/atomic_file.hpp"
#include "kernel/base/files/file_error.hpp"
#include "kernel/base/files/partial_file.hpp"
#include "kernel/base/files/text_file.hpp"

namespace faster::io {
namespace {

namespace fs = std::filesystem;

/// The folder in which a file or its missing parents would be made.
fs::path nearest_folder(fs::path const& file) {
    fs::path folder = file.parent_path();
    while (!fs::exists(folder))
        folder = folder.parent_path();
    return folder;
}

}  // namespace

OutputFile::OutputFile(fs::path const& target) : target_(target) {
    if (!target_.has_filename())
        throw InputError("\"" + target_.string() + "\" names no file, expected a path to write to");
    try {
        destination_ = fs::weakly_canonical(fs::absolute(target_));
        if (fs::is_directory(destination_))
            fail(target_, "is a folder, expected a file to write");
        if (fs::exists(destination_) && !fs::is_regular_file(destination_))
            fail(target_, "is no regular file, expected a new file or one to replace");
        fs::path const folder = nearest_folder(destination_);
        if (!fs::is_directory(folder))
            fail(target_, "cannot be written (" + folder.string() + " is no folder)");
        PartialFile const probe(folder / destination_.filename());
        try {
            write_file(probe.path(), "");
        } catch (InputError const&) {
            fail(target_, "cannot be written in " + folder.string());
        }
    } catch (fs::filesystem_error const& error) {
        fail_to_write(target_, error.code().message());
    }
}

void OutputFile::commit(std::function<void(std::ostream&)> const& write) const {
    try {
        fs::create_directories(destination_.parent_path());
        PartialFile const partial(destination_);
        std::ofstream stream(partial.path(), std::ios::binary | std::ios::trunc);
        write(stream);
        stream.close();
        if (!stream)
            fail(target_, "cannot be written");
        fs::rename(partial.path(), destination_);
    } catch (fs::filesystem_error const& error) {
        fail_to_write(target_, error.code().message());
    }
}

void OutputFile::commit(std::string_view content) const {
    try {
        fs::create_directories(destination_.parent_path());
        write_file_atomically(destination_, content);
    } catch (fs::filesystem_error const& error) {
        fail_to_write(target_, error.code().message());
    }
}

}  // namespace faster::io
