#include "dataflow/base/files/scratch.hpp"

#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

#include "dataflow/base/files/hidden_name.hpp"
#include "dataflow/base/files/kept_rights.hpp"

namespace dataflow::io {
namespace {

namespace fs = std::filesystem;

/// Whether it was made; an error unless the name is taken, or its folder is gone.
bool is_made(fs::path const& path, Scratch::Kind kind) {
    int result = -1;
    if (kind == Scratch::Kind::folder)
        result = mkdir(path.c_str(), 0777);
    else
        result = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (result < 0 && errno != EEXIST && errno != ENOENT)
        throw fs::filesystem_error("create", path, std::error_code(errno, std::generic_category()));
    if (result >= 0 && kind == Scratch::Kind::file)
        close(result);
    return result >= 0;
}

void remove_if_left(fs::path const& path) {
    std::error_code ignored;
    auto const hold = hold_if_free(path);
    if (!hold)
        return;
    fs::remove(path.string() + ".hier", ignored);  // of GTKWave's code for FST files
    fs::remove_all(path, ignored);
}

}  // namespace

Scratch::Scratch(fs::path const& target, Kind kind) : target_(target) {
    for (fs::path const& left : all_hidden_beside(target_, "partial"))
        remove_if_left(left);
    try {
        make(kind);
    } catch (...) {
        remove();
        throw;
    }
}

/// Other processes may remove what they have made, which this one has found there; and until it is held, they may take
/// it for something that was left.
void Scratch::make(Kind kind) {
    constexpr int most_tries = 1000;
    for (int i = 0; i < most_tries; ++i) {
        make_parents(target_.parent_path());
        path_ = hidden_name(target_, "partial");
        if (!is_made(path_, kind))
            continue;
        hold();
        if (hold_ && !hold_->is_held_by_another() && hold_->is_at(path_))
            return keep_rights_while_writing(target_, path_);
        hold_.reset();
    }
    throw fs::filesystem_error("create", path_, std::make_error_code(std::errc::no_such_file_or_directory));
}

void Scratch::make_parents(fs::path const& folder) {
    if (fs::exists(folder))
        return;
    make_parents(folder.parent_path());
    std::error_code error;
    if (fs::create_directory(folder, error))
        made_parents_.push_back(folder);
    else if (error && error != std::errc::no_such_file_or_directory)
        throw fs::filesystem_error("create", folder, error);
}

void Scratch::hold() {
    try {
        hold_.emplace(path_);
    } catch (fs::filesystem_error const& error) {
        if (error.code() != std::errc::no_such_file_or_directory)
            throw;
    }
}

void Scratch::replace_target() const {
    keep_rights(target_, path_);
    fs::rename(path_, target_);
}

void Scratch::remove() {
    std::error_code ignored;
    if (!path_.empty() && std::remove(path_.c_str()) != 0 && errno != ENOENT) {
        fs::remove_all(path_, ignored);
        hold_.reset();  // its descriptor may be the one that was missing
        fs::remove_all(path_, ignored);
    }
    for (; !made_parents_.empty(); made_parents_.pop_back())
        rmdir(made_parents_.back().c_str());  // only if it is empty
}

}  // namespace dataflow::io
