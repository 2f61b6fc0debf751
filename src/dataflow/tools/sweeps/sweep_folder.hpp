#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "dataflow/base/files/folder_lock.hpp"
#include "dataflow/tools/sweeps/manifest.hpp"

namespace dataflow::sweeps {

/// The output folder of a sweep, which one process has to itself while this lives.
///   sweep.json   the manifest
///   journal      results as they come, see Journal
///   events/      event files of functions that are still needed
///   results.csv  the table
///   index.html   the page
class SweepFolder {
  public:
    /// Makes the folder if there is none, and takes it. Throws InputError if it holds something else, cannot be written
    /// or another process has it.
    explicit SweepFolder(std::filesystem::path const& folder);
    /// Removes what processes of this one that were killed left half-written.
    ~SweepFolder();
    SweepFolder(SweepFolder const&) = delete;
    SweepFolder& operator=(SweepFolder const&) = delete;

    /// Makes it the folder of that sweep. If it is one already, the manifest must have all of its points: results are
    /// kept, and others added. Throws InputError otherwise.
    void adopt(Manifest const& manifest);

    std::filesystem::path journal() const { return folder_ / "journal"; }
    std::filesystem::path table() const { return folder_ / "results.csv"; }
    std::filesystem::path page() const { return folder_ / "index.html"; }
    /// Of the function with that hash.
    std::filesystem::path events(std::string const& function) const;
    /// Makes the folder of event files, and removes what a process that was killed left half-written.
    void prepare_events() const;
    /// If it is empty.
    void remove_events_folder() const;

  private:
    void remove_partial_files() const;

    std::filesystem::path folder_;
    std::optional<io::FolderLock> lock_;
};

/// Makes the folder of results that come one by one, if there is none. `kind`: what it is for, as messages say. Throws
/// InputError if it cannot be made, or holds something else.
void take_folder(std::filesystem::path const& folder, std::string const& kind,
                 std::function<bool()> const& is_of_that_kind);

bool is_sweep_folder(std::filesystem::path const& folder);

/// The manifest of a folder that a sweep wrote. Throws InputError if it is none.
Manifest read_manifest_of(std::filesystem::path const& folder);

}  // namespace dataflow::sweeps
