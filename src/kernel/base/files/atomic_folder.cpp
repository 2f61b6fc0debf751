#include "kernel/base/files/atomic_folder.hpp"

#include <algorithm>
#include <system_error>
#include <utility>

#include "kernel/base/files/file_error.hpp"
#include "kernel/base/files/hidden_name.hpp"

namespace faster::io {
namespace {

namespace fs = std::filesystem;

/// "/a/b/" and "/a/b" are the same folder; only the second has a name to derive a sibling from.
fs::path resolved(fs::path const& target) {
    fs::path const absolute = fs::weakly_canonical(fs::absolute(target));
    return absolute.has_filename() ? absolute : absolute.parent_path();
}

}  // namespace

AtomicFolder::AtomicFolder(fs::path const& target, FolderKind kind) : target_(target), kind_(std::move(kind)) {
    if (target_.empty()) {
        throw InputError("the name of the output folder is empty, expected a path");
    }
    try {
        destination_ = resolved(target_);
        require_replaceable();
        make_scratch();  // to see whether that can be done
        remove_scratch();
    } catch (fs::filesystem_error const& error) {
        remove_scratch();
        fail(error);
    }
}

AtomicFolder::~AtomicFolder() {
    if (!committed_) {
        remove_scratch();
    }
}

fs::path const& AtomicFolder::path() {
    try {
        if (scratch_.empty()) {
            make_scratch();
        }
    } catch (fs::filesystem_error const& error) {
        fail(error);
    }
    return scratch_;
}

void AtomicFolder::remove_scratch() {
    std::error_code ignored;
    if (!scratch_.empty()) {
        fs::remove_all(scratch_, ignored);
    }
    scratch_.clear();
    remove_made_parents();
    first_made_parent_.clear();
}

void AtomicFolder::remove_made_parents() const {
    if (first_made_parent_.empty()) {
        return;
    }
    std::error_code ignored;
    fs::path parent = destination_.parent_path();
    while (fs::remove(parent, ignored) && parent != first_made_parent_) {  // only while empty
        parent = parent.parent_path();
    }
}

void AtomicFolder::commit() {
    path();
    try {
        if (fs::exists(destination_) && !fs::is_empty(destination_)) {
            replace_older();
        } else {
            fs::rename(scratch_, destination_);
            committed_ = true;
        }
    } catch (fs::filesystem_error const& error) {
        fail(error);
    }
}

void AtomicFolder::require_replaceable() const {
    if (!fs::exists(destination_)) {
        return;
    }
    if (!fs::is_directory(destination_)) {
        fail("is a file, expected a folder to write a " + kind_.name + " into");
    }
    if (!fs::is_empty(destination_) && !fs::exists(destination_ / kind_.marker)) {
        fail("holds other files, expected a new or empty folder or an older " + kind_.name);
    }
}

void AtomicFolder::make_parents() {
    fs::path missing;
    for (fs::path parent = destination_.parent_path(); !fs::exists(parent); parent = parent.parent_path()) {
        missing = parent;
    }
    fs::create_directories(destination_.parent_path());
    first_made_parent_ = missing;
}

void AtomicFolder::make_scratch() {
    make_parents();
    do {
        scratch_ = hidden_name(destination_, "partial");
    } while (!fs::create_directory(scratch_));
}

void AtomicFolder::replace_older() {
    require_replaceable();  // it may have changed since the start of the run
    fs::path const older = hidden_name(destination_, "older");
    fs::rename(destination_, older);
    try {
        fs::rename(scratch_, destination_);
    } catch (fs::filesystem_error const&) {
        fs::rename(older, destination_);
        throw;
    }
    committed_ = true;
    keep_foreign_files(older);
    fs::remove_all(older);
}

void AtomicFolder::keep_foreign_files(fs::path const& older) const {
    std::vector<fs::path> names;  // moving files while listing their folder may skip some
    for (auto const& entry : fs::directory_iterator(older)) {
        names.push_back(entry.path().filename());
    }
    for (auto const& name : names) {
        if (!is_ours(name.string()) && !fs::exists(destination_ / name)) {
            fs::rename(older / name, destination_ / name);
        }
    }
}

bool AtomicFolder::is_ours(std::string const& file) const {
    return file == kind_.marker || std::find(kind_.others.begin(), kind_.others.end(), file) != kind_.others.end();
}

void AtomicFolder::fail(std::string const& what) const { io::fail(target_, what); }

void AtomicFolder::fail(fs::filesystem_error const& error) const { fail_to_write(target_, error.code().message()); }

}  // namespace faster::io
