#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace dataflow::io {

/// What a folder of one kind (trace, results of a run) is made of: how an older one is recognised and replaced.
struct FolderKind {
    std::string name;    ///< for messages, e.g. "stimulus trace"
    std::string marker;  ///< the file every folder of this kind has
    /// Further files and folders that a newer folder replaces or drops. Of a folder in which people may keep something
    /// of theirs, which files: "images/sample_*.png".
    std::vector<std::string> others;
    /// What the marker says of itself, so that another's file of the same name is not taken for it: the text of its key
    /// `format` if it is JSON or YAML, or else how it begins. Empty: whatever it says.
    std::string format = {};

    /// Whether such a folder has something of that name, of its own.
    bool has(std::string const& file) const;
    /// Whether all of a file or folder is of that kind; `path` is relative to the folder.
    bool owns(std::filesystem::path const& path) const;
    /// Whether the folder has the marker, and that is what it says it is.
    bool is_kind_of(std::filesystem::path const& folder) const;
};

}  // namespace dataflow::io
