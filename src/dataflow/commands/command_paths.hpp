#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "dataflow/base/files/folder_kind.hpp"
#include "dataflow/run/config/run_config.hpp"

namespace dataflow {

/// The paths of one command, to see that none of its outputs gets onto another, or onto what it reads: each call throws
/// an InputError if the path does so with one given before. Empty paths, devices and pipes are none.
class CommandPaths {
  public:
    void reads(std::filesystem::path const& path);
    /// The files and folders that it names.
    void reads(RunConfig const& config);
    /// A folder of that kind, of which only what belongs to the kind is read.
    void reads(std::filesystem::path const& path, io::FolderKind const& kind);
    /// `what`: for messages, e.g. "--report"
    void writes(std::string const& what, std::filesystem::path const& file);
    void writes(std::string const& what, std::filesystem::path const& folder, io::FolderKind const& kind);

  private:
    struct GivenPath {
        std::string what;                   // empty: it is read
        std::filesystem::path given, path;  // the latter absolute, symbolic links resolved
        io::FolderKind const* kind;         // null: a file, or a folder that is read
    };
    void add(std::string const& what, std::filesystem::path const& given, io::FolderKind const* kind);
    static bool covers(GivenPath const& place, std::filesystem::path const& path);
    static void require_apart(GivenPath const& older, GivenPath const& newer);

    std::vector<GivenPath> paths_;
};

}  // namespace dataflow
