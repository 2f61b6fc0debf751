#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace faster::io {

/// What a folder of one kind (trace, results of a run) is made of: how an older one is recognised and replaced.
struct FolderKind {
    std::string name;                 ///< for messages, e.g. "stimulus trace"
    std::string marker;               ///< the file every folder of this kind has
    std::vector<std::string> others;  ///< further files and folders that a newer folder replaces or drops
};

/// An output folder that appears complete or not at all. Files are written below `path()`, a hidden folder beside the
/// target that is made when it is first asked for; `commit()` gives it its name. Without commit the destructor removes
/// it, so a failed run leaves nothing; nor does one that is killed before it writes.
///
/// The target may be missing (parents are made), empty, or an older folder of the same kind, which is replaced; files
/// in it that are not of that kind (a note, a waveform) survive. Anything else, and a place that cannot be written, is
/// an InputError from the constructor: before the work whose output would be lost.
class AtomicFolder {
  public:
    AtomicFolder(std::filesystem::path const& target, FolderKind kind);
    ~AtomicFolder();
    AtomicFolder(AtomicFolder const&) = delete;
    AtomicFolder& operator=(AtomicFolder const&) = delete;

    /// Where to write until commit().
    std::filesystem::path const& path();
    /// The folder as the user named it, for messages.
    std::filesystem::path const& target() const { return target_; }
    void commit();

  private:
    void require_replaceable() const;
    void make_scratch();
    void make_parents();
    void remove_scratch();
    void remove_made_parents() const;
    void replace_older();
    void keep_foreign_files(std::filesystem::path const& older) const;
    bool is_ours(std::string const& file) const;
    [[noreturn]] void fail(std::string const& what) const;
    [[noreturn]] void fail(std::filesystem::filesystem_error const& error) const;

    std::filesystem::path target_;             // as given
    std::filesystem::path destination_;        // absolute, symbolic links resolved
    std::filesystem::path scratch_;            // empty until it is made
    std::filesystem::path first_made_parent_;  // empty if all existed
    FolderKind kind_;
    bool committed_ = false;
};

}  // namespace faster::io
