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
    /// A page that people often let a command write into such a folder: it tells of the results there, so that a newer
    /// folder drops it too, if one of the texts is in it, which pages of ours alone have. Empty: none.
    std::string page = {};
    std::vector<std::string> page_texts = {};

    /// Whether such a folder has something of that name, of its own.
    bool has(std::string const& file) const;
    /// Whether all of a file or folder is of that kind; `path` is relative to the folder.
    bool owns(std::filesystem::path const& path) const;
    /// Whether a file of such a folder is that page; `path` is relative to the folder.
    bool has_page(std::filesystem::path const& folder, std::filesystem::path const& path) const;
    /// Whether the folder has the marker, and that is what it says it is.
    bool is_kind_of(std::filesystem::path const& folder) const;
};

}  // namespace dataflow::io
