#include "kernel/base/files/folder_exchange.hpp"

#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <system_error>
#include <vector>

#include "kernel/base/files/hidden_name.hpp"
#include "kernel/base/files/hold.hpp"

namespace faster::io {
namespace {

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

/// Moving files while listing their folder may skip some.
std::vector<fs::path> names_in(fs::path const& folder) {
    std::vector<fs::path> names;
    for (auto const& entry : fs::directory_iterator(folder))
        names.push_back(entry.path().filename());
    return names;
}

void bring_back(fs::path const& older, fs::path const& folder, FolderKind const& kind) {
    if (!fs::exists(folder))
        return fs::rename(older, folder);
    for (fs::path const& name : names_in(older))
        if (!kind.has(name.string()) && !fs::exists(folder / name))
            fs::rename(older / name, folder / name);
    fs::remove_all(older);
}

}  // namespace

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

void bring_back_older(fs::path const& folder, FolderKind const& kind) {
    for (fs::path const& older : all_hidden_beside(folder, "older"))
        if (auto const hold = hold_if_free(older))
            bring_back(older, folder, kind);
}

}  // namespace faster::io
