#include "dataflow/base/files/output_file.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <string>
#include <system_error>

#include "dataflow/base/files/file_error.hpp"
#include "dataflow/base/files/hidden_name.hpp"
#include "dataflow/base/files/scratch.hpp"
#include "dataflow/base/files/text_file.hpp"

namespace dataflow::io {
namespace {

namespace fs = std::filesystem;

/// Gives up when a signal is held back.
class InterruptibleBuffer : public std::filebuf {
  protected:
    int_type overflow(int_type letter) override {
        processes::give_up_if_interrupted();
        return std::filebuf::overflow(letter);
    }
    std::streamsize xsputn(char const* text, std::streamsize count) override {
        processes::give_up_if_interrupted();
        return std::filebuf::xsputn(text, count);
    }
};

/// Throws std::ios_base::failure if not all can be written.
void write_stream(fs::path const& path, std::function<void(std::ostream&)> const& write) {
    InterruptibleBuffer buffer;
    buffer.open(path, std::ios::out | std::ios::binary | std::ios::trunc);
    std::ostream stream(&buffer);
    stream.exceptions(std::ios::badbit);
    if (!buffer.is_open())
        stream.setstate(std::ios::badbit);
    write(stream);
    if (buffer.close() == nullptr)
        stream.setstate(std::ios::badbit);
}

}  // namespace

bool is_device(fs::path const& file) {
    std::error_code none;
    fs::file_status const status = fs::status(file, none);
    return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

OutputFile::OutputFile(fs::path const& target) : target_(without_hidden_names(target)) {
    if (!target_.has_filename())
        throw InputError("\"" + target_.string() + "\" names no file, expected a path to write to");
    if (is_device(target))  // before its links are followed: that of /dev/stdout may lead to no path
        fail(target_, "is no regular file, expected a new file or one to replace");
    try {
        destination_ = fs::weakly_canonical(fs::absolute(target));
        if (fs::is_directory(destination_))
            fail(target_, "is a folder, expected a file to write");
        Scratch const probe(destination_, Scratch::Kind::file);
    } catch (fs::filesystem_error const& error) {
        fail_to_write(target_, error.code().message());
    }
}

void OutputFile::commit(std::function<void(std::ostream&)> const& write) const {
    try {
        Scratch const scratch(destination_, Scratch::Kind::file);
        errno = 0;
        write_stream(scratch.path(), write);
        scratch.replace_target();
    } catch (fs::filesystem_error const& error) {
        fail_to_write(target_, error.code().message());
    } catch (std::ios_base::failure const&) {
        fail_to_write(target_, errno != 0 ? std::strerror(errno) : "no room for it, or not allowed");
    }
}

void OutputFile::commit(std::string_view content) const {
    commit([content](std::ostream& stream) { stream.write(content.data(), std::streamsize(content.size())); });
}

}  // namespace dataflow::io
