#include "dataflow/base/files/kept_rights.hpp"

#include <cerrno>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace dataflow::io {
namespace {

namespace fs = std::filesystem;

/// Tries to give a file its owner and group, and says whether it has the group: only root may give a file away,
/// everybody to groups of theirs.
bool gets_group(fs::path const& path, struct stat const& wanted, struct stat& is) {
    bool const is_another = is.st_uid != wanted.st_uid || is.st_gid != wanted.st_gid;
    if (is_another && chown(path.c_str(), wanted.st_uid, wanted.st_gid) != 0 && is.st_gid != wanted.st_gid)
        [[maybe_unused]]
        int const no_matter = chown(path.c_str(), static_cast<uid_t>(-1), wanted.st_gid);
    stat(path.c_str(), &is);  // it takes bits away
    return is.st_gid == wanted.st_gid;
}

mode_t without_group(mode_t mode) {
    mode_t const of_all = mode & S_IRWXO;
    return (mode & ~mode_t{S_IRWXG | S_ISGID}) | (mode & (of_all << 3U));
}

/// New content is not to run as somebody else because the old one did.
mode_t bits_kept(bool is_folder) { return is_folder ? 07777 : 0777; }

void keep(fs::path const& from, fs::path const& to, bool is_being_written) {
    struct stat wanted {};
    struct stat is {};
    if (stat(from.c_str(), &wanted) != 0 || stat(to.c_str(), &is) != 0 ||
        S_ISDIR(wanted.st_mode) != S_ISDIR(is.st_mode))
        return;
    bool const is_folder = S_ISDIR(is.st_mode);
    mode_t mode = gets_group(to, wanted, is) ? wanted.st_mode : without_group(wanted.st_mode);
    if (is_being_written)
        mode |= is_folder ? S_IRWXU : S_IRUSR | S_IWUSR;
    mode &= bits_kept(is_folder);
    if (mode != (is.st_mode & 07777U) && chmod(to.c_str(), mode) != 0)
        throw fs::filesystem_error("chmod", to, std::error_code(errno, std::generic_category()));
}

}  // namespace

void keep_rights(fs::path const& from, fs::path const& to) { keep(from, to, false); }

void keep_rights_while_writing(fs::path const& from, fs::path const& to) { keep(from, to, true); }

}  // namespace dataflow::io
