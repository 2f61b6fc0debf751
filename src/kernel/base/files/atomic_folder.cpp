#include "kernel/base/files/atomic_folder.hpp"

#include <algorithm>
#include <system_error>
#include <utility>

#include "kernel/base/files/file_error.hpp"
#include "kernel/base/files/folder_exchange.hpp"
#include "kernel/base/files/linked_copy.hpp"

namespace faster::io {
namespace {

namespace fs = std::filesystem;

/// "/a/b/" and "/a/b" are the same folder; only the second has a name to derive a sibling from.
fs::path resolved(fs::path const& target) {
    fs::path const absolute = fs::weakly_canonical(fs::absolute(target));
    return absolute.has_filename() ? absolute : absolute.parent_path();
}

bool has_files(fs::path const& folder) { return fs::exists(folder) && !fs::is_empty(folder); }

}  // namespace

AtomicFolder::AtomicFolder(fs::path const& target, FolderKind kind) : target_(target), kind_(std::move(kind)) {
    if (target_.empty())
        throw InputError("the name of the output folder is empty, expected a path");
    try {
        destination_ = resolved(target_);
        require_place();
        bring_back_older(destination_, kind_);
        require_replaceable();
        Scratch const probe(destination_, Scratch::Kind::folder);
    } catch (fs::filesystem_error const& error) {
        fail(error);
    }
}

fs::path const& AtomicFolder::path() {
    try {
        if (!scratch_)
            scratch_.emplace(destination_, Scratch::Kind::folder);
    } catch (fs::filesystem_error const& error) {
        fail(error);
    }
    return scratch_->path();
}

fs::path AtomicFolder::place_of(fs::path const& file) {
    fs::path const below = fs::weakly_canonical(fs::absolute(file)).lexically_relative(destination_);
    if (below.empty() || *below.begin() == "..")
        return file;
    fs::path place = path() / below;
    fs::create_directories(place.parent_path());
    return place;
}

void AtomicFolder::commit() {
    path();
    try {
        while (!(has_files(destination_) ? try_to_replace() : try_to_appear())) {
        }
        scratch_.reset();
    } catch (fs::filesystem_error const& error) {
        fail(error);
    }
}

/// A folder that is replaced while somebody stands in it is gone for them.
void AtomicFolder::require_place() const {
    fs::path const here = fs::current_path();
    if (std::mismatch(destination_.begin(), destination_.end(), here.begin(), here.end()).first == destination_.end())
        fail("is the current folder or one above it, expected a folder of its own: it is replaced as a whole");
}

void AtomicFolder::require_replaceable() const {
    if (!fs::exists(destination_))
        return;
    if (!fs::is_directory(destination_))
        fail("is a file, expected a folder to write a " + kind_.name + " into");
    if (!fs::is_empty(destination_) && !fs::exists(destination_ / kind_.marker))
        fail("holds other files, expected a new or empty folder or an older " + kind_.name);
}

/// False if there is a folder with files by now: another process was quicker.
bool AtomicFolder::try_to_appear() const {
    std::error_code error;
    fs::rename(scratch_->path(), destination_, error);
    if (error && !has_files(destination_))
        throw fs::filesystem_error("rename", destination_, error);
    return !error;
}

/// False if it is gone by now.
bool AtomicFolder::try_to_replace() const {
    require_replaceable();  // it may have changed since the start of the run
    keep_foreign_files();
    return exchange_folders(scratch_->path(), destination_);
}

void AtomicFolder::keep_foreign_files() const {
    for (auto const& entry : fs::directory_iterator(destination_)) {
        fs::path const name = entry.path().filename();
        if (!kind_.has(name.string()) && !fs::exists(scratch_->path() / name))
            copy_as_links(entry.path(), scratch_->path() / name);
    }
}

void AtomicFolder::fail(std::string const& what) const { io::fail(target_, what); }

void AtomicFolder::fail(fs::filesystem_error const& error) const { fail_to_write(target_, error.code().message()); }

}  // namespace faster::io
