#include "dataflow/base/files/atomic_folder.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <system_error>
#include <utility>
#include <vector>

#include "dataflow/base/files/file_error.hpp"
#include "dataflow/base/files/hidden_name.hpp"
#include "dataflow/base/files/hold.hpp"
#include "dataflow/base/files/kept_rights.hpp"

namespace dataflow::io {

namespace {

namespace fs = std::filesystem;

/// Makes `to`, which is not there, all that `from` is. Files become further names of the same file, or copies where the
/// file system has no such names. Throws std::filesystem::filesystem_error.
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

namespace fs = std::filesystem;

void exchange_in_two_steps(fs::path const& from, fs::path const& to) {
    Hold const hold(to);  // nobody is to bring it back meanwhile
    fs::path const older = hidden_name(to, "older");
    fs::rename(to, older);
    try {
        fs::rename(from, to);
    } catch (fs::filesystem_error const&) {
        fs::rename(older, to);
        throw;
    }
    std::error_code ignored;
    fs::remove_all(older, ignored);
}

/// What of a folder is not of its kind: files, and folders of which nothing is; relative to it. Listed before anything
/// is moved, which may make a listing skip some.
std::vector<fs::path> foreign_things(fs::path const& folder, FolderKind const& kind, fs::path const& below = {}) {
    std::vector<fs::path> foreign;
    for (auto const& entry : fs::directory_iterator(folder / below)) {
        fs::path const path = below / entry.path().filename();
        if (kind.owns(path) || kind.has_page(folder, path))
            continue;
        bool const may_hold_both = kind.has(path.begin()->string()) && fs::is_directory(entry.symlink_status());
        if (!may_hold_both) {
            foreign.push_back(path);
            continue;
        }
        std::vector<fs::path> const inside = foreign_things(folder, kind, path);
        foreign.insert(foreign.end(), inside.begin(), inside.end());
    }
    return foreign;
}

/// The folders above a path, as they are in `from`, where `to` lacks them. False if something else is in its place.
bool makes_way(fs::path const& path, fs::path const& from, fs::path const& to) {
    fs::path const above = path.parent_path();
    if (!above.empty() && makes_way(above, from, to) && !fs::exists(fs::symlink_status(to / above)))
        fs::create_directory(to / above, from / above);
    return (above.empty() || fs::is_directory(to / above)) && !fs::exists(fs::symlink_status(to / path));
}

void bring_back(fs::path const& older, fs::path const& folder, FolderKind const& kind) {
    if (!fs::exists(folder))
        return fs::rename(older, folder);
    for (fs::path const& path : foreign_things(older, kind))
        if (makes_way(path, older, folder))
            fs::rename(older / path, folder / path);
    fs::remove_all(older);
}

/// Two folders change names in one step. Where the file system cannot do that, `to` is renamed to a hidden name, `from`
/// becomes `to`, and the former `to` is removed; a process killed in between leaves no `to`, see bring_back_older().
/// False if `to` is gone. Throws std::filesystem::filesystem_error if it cannot be done; both are as before then.
bool exchange_folders(fs::path const& from, fs::path const& to) {
    if (renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_EXCHANGE) == 0)
        return true;
    std::error_code const error(errno, std::generic_category());
    if (error == std::errc::no_such_file_or_directory)
        return false;
    if (error != std::errc::invalid_argument && error != std::errc::function_not_supported)
        throw fs::filesystem_error("rename", to, error);
    exchange_in_two_steps(from, to);
    return true;
}

/// If a process was killed in exchange_folders(): where there is no `folder`, its older one gets its name back; where
/// there is one by now, files of the older one that are not of that kind are moved into it, unless there are such.
/// Throws std::filesystem::filesystem_error.
void bring_back_older(fs::path const& folder, FolderKind const& kind) {
    for (fs::path const& older : all_hidden_beside(folder, "older"))
        if (auto const hold = hold_if_free(older))
            bring_back(older, folder, kind);
}

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
        require_folder(target_);  // before its links are followed, as OutputFile
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

void AtomicFolder::require_folder(fs::path const& place) const {
    if (fs::exists(place) && !fs::is_directory(place))
        fail("is a file, expected a folder to write a " + kind_.name + " into");
}

void AtomicFolder::require_replaceable() const {
    require_folder(destination_);
    if (!fs::exists(destination_))
        return;
    if (fs::is_empty(destination_) || kind_.is_kind_of(destination_))
        return;
    bool const has_marker = !kind_.format.empty() && fs::exists(destination_ / kind_.marker);
    fail("holds " + (has_marker ? "a " + kind_.marker + " of something else" : "other files") +
         ", expected a new or empty folder or an older " + kind_.name);
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
    keep_rights_of_older();
    return exchange_folders(scratch_->path(), destination_);
}

void AtomicFolder::keep_foreign_files() const {
    for (fs::path const& path : foreign_things(destination_, kind_))
        if (makes_way(path, destination_, scratch_->path()))
            copy_as_links(destination_ / path, scratch_->path() / path);
}

/// Of the folder and of all in it that is written anew.
void AtomicFolder::keep_rights_of_older() const {
    for (auto const& entry : fs::recursive_directory_iterator(scratch_->path())) {
        fs::path const path = entry.path().lexically_relative(scratch_->path());
        if (kind_.has(path.begin()->string()) && !entry.is_symlink())
            keep_rights(destination_ / path, entry.path());
    }
    keep_rights(destination_, scratch_->path());
}

void AtomicFolder::fail(std::string const& what) const { io::fail(target_, what); }

void AtomicFolder::fail(fs::filesystem_error const& error) const { fail_to_write(target_, error.code().message()); }

}  // namespace dataflow::io
