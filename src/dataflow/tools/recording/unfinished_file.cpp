#include "dataflow/tools/recording/unfinished_file.hpp"

#include <cerrno>
#include <cstring>
#include <utility>

#include "dataflow/base/files/file_error.hpp"
#include "dataflow/base/files/hidden_name.hpp"
#include "dataflow/base/files/output_file.hpp"

namespace dataflow::recording {

UnfinishedFile::UnfinishedFile(std::filesystem::path file) : file_(std::move(file)) {
    if (io::is_device(file_))
        return;
    try {
        scratch_.emplace(std::filesystem::weakly_canonical(std::filesystem::absolute(file_)), io::Scratch::Kind::file);
    } catch (std::filesystem::filesystem_error const& error) {
        errno = error.code().value();
        fail();
    }
}

void UnfinishedFile::finish() {
    try {
        if (scratch_)
            scratch_->replace_target();
    } catch (std::filesystem::filesystem_error const& error) {
        errno = error.code().value();
        fail();
    }
    scratch_.reset();
}

void UnfinishedFile::fail() const { io::fail_to_write(io::without_hidden_names(file_), std::strerror(errno)); }

}  // namespace dataflow::recording
